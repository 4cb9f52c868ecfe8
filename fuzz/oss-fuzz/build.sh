#!/bin/bash -eu
# Builds every target with cargo-fuzz and puts it where OSS-Fuzz and ClusterFuzzLite look, with its seeds and dictionary.
cd "$SRC/radcomp/fuzz"
# A coverage build has its flags from the environment.
sanitizer=${SANITIZER:-address}
[[ $sanitizer != coverage ]] || sanitizer=none
# Optimised, with debug assertions: what `cargo fuzz run` builds.
cargo fuzz build -O --debug-assertions --sanitizer "$sanitizer"

release=target/x86_64-unknown-linux-gnu/release
for target in model_and_implementation kernels metamorphic reader round_trip profile_file safety hostile_device hostile_caller; do
    cp "$release/$target" "$OUT/"
    case $target in
        reader | kernels | hostile_device | hostile_caller) seeds=seeds/$target ;;
        profile_file) seeds=../spec/profiles ;;
        *) seeds=seeds/programs ;;
    esac
    zip -q -j "$OUT/${target}_seed_corpus.zip" "$seeds"/*
done
cp dictionaries/gcode.dict "$OUT/reader.dict"
cp dictionaries/profile.dict "$OUT/profile_file.dict"
for target in hostile_device hostile_caller; do cp dictionaries/protocol.dict "$OUT/$target.dict"; done
