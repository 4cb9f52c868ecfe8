//! Small working adapters to start from.

/// A file of an adapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KitFile {
    /// Its path within the adapter's folder.
    pub path: &'static str,
    /// Its text.
    pub text: &'static str,
}

/// The files of the adapter in a language: `python`, `rust`, or `c`, a shared library; none for another language.
pub fn files(language: &str) -> Option<&'static [KitFile]> {
    const PROTOCOL: KitFile = KitFile { path: "pipe.schema.json", text: super::wire::SCHEMA };
    const PYTHON: &[KitFile] = &[KitFile { path: "adapter.py", text: include_str!("adapter.py") }, PROTOCOL];
    const C: &[KitFile] = &[
        KitFile { path: "device.c", text: include_str!("../../../examples/c/device.c") },
        KitFile { path: "radcomp.h", text: include_str!("../../../impl/c/include/radcomp.h") },
    ];
    const RUST: &[KitFile] = &[
        KitFile { path: "Cargo.toml", text: include_str!("rust/Cargo.toml.txt") },
        KitFile { path: "src/main.rs", text: include_str!("rust/main.rs") },
        PROTOCOL,
    ];
    match language {
        "python" => Some(PYTHON),
        "rust" => Some(RUST),
        "c" => Some(C),
        _ => None,
    }
}
