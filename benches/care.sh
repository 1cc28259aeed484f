#!/usr/bin/env bash
# Prints README's table "The price of care": instructions a pixel of a textbook tracer and of this one, by valgrind.
# Two sizes are subtracted, so that what a process costs by itself drops out. Usage: benches/care.sh [SCENE]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scene=${1:-scenes/official.txt}
small=64 large=128
# Some machines' C libraries copy and clear kilobytes by an instruction that valgrind counts once a byte.
export GLIBC_TUNABLES=glibc.cpu.x86_rep_movsb_threshold=1073741824:glibc.cpu.x86_rep_stosb_threshold=1073741824
built=$(cargo bench --quiet --no-default-features --bench care --no-run --message-format=json)
program=$(sed -n 's/.*"name":"care".*"executable":"\([^"]*\)".*/\1/p' <<<"$built" | tail -1)

instructions() {
    local said
    # Valgrind stops at instructions that it does not know: what it has counted until then is no figure.
    if ! said=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$1" "$2" "$scene" "$3" 2>&1); then
        echo "$0: valgrind cannot run this program" >&2
        kill $$
    fi
    sed -n 's/.*Collected : //p' <<<"$said"
}

a_pixel() {
    local low high
    low=$(instructions "$1" "$2" $small)
    high=$(instructions "$1" "$2" $large)
    echo $(((high - low) / (large * large - small * small)))
}

base=$(a_pixel naive f32)
row() {
    local count=$base
    [[ "$1 $2" == 'naive f32' ]] || count=$(a_pixel "$1" "$2")
    printf '| %s | `%s` | %d | %+d %% |\n' "$3" "$2" "$count" $(((100 * count + base / 2) / base - 100))
}

echo '| tracer | | instructions a pixel | to the first |'
echo '|---|---|---|---|'
for precision in f32 f64; do row naive $precision 'textbook, from 0.001 on'; done
for precision in f32 f64; do row care $precision 'archetrace, ray after ray'; done
for precision in f32 f64; do row packets $precision 'archetrace, as it traces'; done
