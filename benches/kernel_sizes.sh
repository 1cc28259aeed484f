#!/usr/bin/env bash
# What the kernels add to a release program: bytes of code of the packets, for each level of vector instructions, of the
# searches of trees and of lists of rays that they share, and of the stages that trace ray by ray. Of packets, the smaller half
# of the copies is for the smaller kernel, in both precisions.
# With --times, also the processor seconds that it takes to build the program as it is, without code for AVX, and without
# any effect; that takes half an hour.
#
# Usage: benches/kernel_sizes.sh [--times] [PROGRAM]
# PROGRAM is target/release/archetrace, built here, unless given. Needs nm.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
times=0
if [[ ${1:-} == --times ]]; then times=1 && shift; fi
program=${1:-}
if [[ -z $program ]]; then
    cargo build --release --quiet --locked
    program=target/release/archetrace
fi

echo '| code | copies | kB | smallest-largest |'
echo '|---|---|---|---|'
nm --print-size --radix=d --demangle --defined-only "$program" | awk '
    $3 !~ /^[tTwW]$/ { next }
    { size = $2; whole += size; name = $0; sub(/^[0-9]+ [0-9]+ . /, "", name); place = "" }
    name ~ /trace::simd::trace_[a-z0-9]+$/ { place = name; sub(/.*trace_/, "packets, ", place) }
    name ~ /trace::simd::run_[a-z0-9]+$/ { place = name; sub(/.*run_/, "trees and lists of rays, ", place) }
    name ~ /trace::tile::trace_each$/ { place = "stages: cameras" }
    name ~ /trace::radiance::(follow_all|Walk<.*>::follow)$/ { place = "stages: rays" }
    name ~ /trace::air::look_beyond$/ { place = "stages: surroundings" }
    name ~ /trace::filtered_color::(filtered_color|board_color)$/ { place = "stages: boards" }
    name ~ /trace::shade::(gather|shine)$/ { place = "stages: lights" }
    name ~ /trace::(radiance::meet|shade::is_hidden)$/ { place = "shared by stages: hits and shadows" }
    place != "" {
        if (!(place in count) || size < least[place]) least[place] = size
        if (size > most[place]) most[place] = size
        count[place]++
        sum[place] += size
    }
    END {
        for (place in count)
            printf "| %s | %d | %.0f | %.1f-%.1f |\n", place, count[place], sum[place] / 1e3, least[place] / 1e3, most[place] / 1e3
        printf "| whole program | | %.0f | |\n", whole / 1e3
    }' | sort

((times)) || exit 0
# Processor seconds of a release build of this crate, in a folder where what it needs has been built before.
seconds() {
    local TIMEFORMAT=%U
    touch src/lib.rs
    { time env "$@" cargo build --release --quiet --locked --bin archetrace --target-dir target/kernel_sizes; } 2>&1
}
effects=$(sed -n 's/.*Self::[A-Za-z]* => "\([a-z_]*\)",$/\1/p' src/effects/effect.rs | tr '\n' ' ')
seconds _= >/dev/null
printf '\n| program | processor seconds to build |\n|---|---|\n'
echo "| as it is | $(seconds _=) |"
echo "| without AVX | $(seconds ARCHETRACE_SIMD=baseline) |"
echo "| without effects | $(seconds ARCHETRACE_WITHOUT="$effects") |"
