#!/usr/bin/env bash
# Whether the kernels of a release program are still made of vector instructions, as the compiler makes them of loops over
# lanes: nothing else notices when it stops. Prints for each kernel how much of its arithmetic is packed. Fails where that is
# less than the shares below, and where code of packets or trees was left out of the kernels: that is compiled for the
# instructions that every processor has (closures are, where there are many copies of their caller: in a build without
# link-time optimisation one in the test of boxes made random rays take 1.6 times as long).
#
# Usage: benches/vectors.sh [PROGRAM]
# PROGRAM is target/release/archetrace, built here, unless given. Needs objdump, and a processor family that has AVX2.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# Percent of arithmetic instructions in the code of a kernel: 81 to 93. The rest is set-up and cases that are rare.
least=${LEAST:-75}
program=${1:-}
if [[ -z $program ]]; then
    cargo build --release --quiet --locked
    program=target/release/archetrace
fi

objdump --disassemble --demangle --no-show-raw-insn "$program" | awk -v least="$least" '
    # "0000000000123456 <archetrace::trace::simd::trace_avx2>:"
    /^[0-9a-f]+ </ {
        name = $0
        sub(/^[0-9a-f]+ </, "", name)
        sub(/>:$/, "", name)
        where = $1
        is_kernel = name ~ /trace::simd::(trace|run)_avx/
        is_left_out = name ~ /trace::(packet|tree)::.*closure/ && name !~ /build|split|fit|drop_in_place/
        next
    }
    is_kernel && $2 ~ /^v(add|sub|mul|div|sqrt|min|max)[ps][sd]$/ {
        all[name " " where]++
        if ($2 ~ /p[sd]$/) packed[name " " where]++
    }
    # Closures given to the array functions of the standard library are sometimes called, lane by lane.
    is_kernel && $2 == "call" && /core::(array|ops::function)::/ { called[name " " where]++ }
    is_left_out && $2 ~ /^(add|sub|mul|div|sqrt|min|max)[ps][sd]$/ { left_out[name]++ }
    END {
        for (kernel in all) {
            share = 100 * packed[kernel] / all[kernel]
            printf "%s: %d of %d packed, %.0f %%%s\n", kernel, packed[kernel], all[kernel], share, share < least ? ": too few" : ""
            if (share < least) failed = 1
            kernels++
        }
        for (closure in left_out) {
            printf "%s: %d instructions outside of the kernels\n", closure, left_out[closure]
            failed = 1
        }
        for (kernel in called) {
            printf "%s: %d calls of closures\n", kernel, called[kernel]
            failed = 1
        }
        if (!kernels) { print "no kernels found"; failed = 1 }
        exit failed
    }'
