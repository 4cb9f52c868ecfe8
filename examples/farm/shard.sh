#!/bin/sh
# Runs one part of a campaign: shard.sh NUMBER OF, counted from 1.
set -eu
number=$1
of=$2
mkdir -p "$REPORTS"

# Exit status 1 is a red verdict, which stands in the report: this part is done.
radcomp certify "${DEVICE:-builtin}" --profile "$PROFILE" --level "${LEVEL:-2}" --seed "${SEED:-1}" \
    --shard "$number/$of" --report "$REPORTS/shard-$number.json" || [ $? -eq 1 ]
