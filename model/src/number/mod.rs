//! Exact real numbers.
