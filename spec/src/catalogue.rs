//! The text of the clauses.
