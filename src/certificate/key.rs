//! Keys.

use std::fmt;

use ed25519_dalek::pkcs8::spki::der::pem::LineEnding;
use ed25519_dalek::pkcs8::{DecodePrivateKey, EncodePrivateKey};
use ed25519_dalek::{Signer, SigningKey};

use crate::report::hex;

/// A private Ed25519 key.
pub struct Key(SigningKey);

/// Why there is no key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KeyError(String);

impl Key {
    /// A new key.
    ///
    /// # Errors
    ///
    /// If the operating system has no random numbers.
    pub fn generate() -> Result<Key, KeyError> {
        let mut seed = [0; 32];
        getrandom::fill(&mut seed).map_err(|error| KeyError(format!("no random numbers: {error}")))?;
        Ok(Key(SigningKey::from_bytes(&seed)))
    }

    /// Reads a key in PKCS #8 PEM, as `openssl genpkey -algorithm ed25519` writes it.
    ///
    /// # Errors
    ///
    /// If the text is no such key.
    pub fn parse(pem: &str) -> Result<Key, KeyError> {
        SigningKey::from_pkcs8_pem(pem)
            .map(Key)
            .map_err(|error| KeyError(format!("not an Ed25519 key in PEM: {error}")))
    }

    /// The key in PKCS #8 PEM.
    ///
    /// # Errors
    ///
    /// If it cannot be written: a fault of the toolkit.
    pub fn pem(&self) -> Result<String, KeyError> {
        let pem = self.0.to_pkcs8_pem(LineEnding::LF).map_err(|error| KeyError(error.to_string()))?;
        Ok(pem.to_string())
    }

    /// The public key, as hexadecimal digits.
    pub fn public(&self) -> String {
        hex(self.0.verifying_key().as_bytes())
    }

    /// The signature of some bytes.
    pub(super) fn sign(&self, bytes: &[u8]) -> [u8; 64] {
        self.0.sign(bytes).to_bytes()
    }
}

impl fmt::Debug for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Key({})", self.public())
    }
}

impl fmt::Display for KeyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for KeyError {}
