//! `include/radcomp.h` is what cbindgen writes from the interface.

use std::path::Path;

#[test]
fn the_header_is_the_interface() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let configuration = cbindgen::Config::from_file(folder.join("cbindgen.toml")).expect("cbindgen.toml");
    let mut builder = cbindgen::Builder::new().with_config(configuration);
    for file in ["status", "block", "step", "state", "device"] {
        builder = builder.with_src(folder.join(format!("src/{file}.rs")));
    }
    let mut written = Vec::new();
    builder.generate().expect("the interface is one of C").write(&mut written);
    let written = String::from_utf8(written).expect("text");
    let file = folder.join("include/radcomp.h");
    if std::env::var_os("BLESS").is_some() {
        std::fs::create_dir_all(folder.join("include")).expect("a folder");
        std::fs::write(&file, &written).expect("include/radcomp.h can be written");
    }
    let kept = std::fs::read_to_string(&file).unwrap_or_default();
    assert!(
        kept == written,
        "include/radcomp.h is not of this interface: BLESS=1 cargo test -p radcomp-c --test header"
    );
}
