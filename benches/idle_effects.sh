#!/usr/bin/env bash
# What an effect costs a scene that does not ask for it: instructions of a frame, with the program as it is to those with a
# program from which the effect is compiled out, by valgrind. Two sizes are subtracted, so that what a process costs by
# itself drops out. Fails where they differ by more than 1 %, where a picture differs, and where a program traces a scene
# that asks for what it was built without.
#
# Usage: benches/idle_effects.sh [EFFECT... [-- SCENE...]]
# A program is built without each EFFECT; several in one word ("fog glass") are left out together, which is a harder test
# than each alone. `all` stands for each effect there is. SCENE is a scene file or a picture of the gallery. Unless given: one
# word of some effects, and some scenes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
small=32 large=128 bound=0.01
left_out=()
while (($# > 0)) && [[ $1 != -- ]]; do left_out+=("$1") && shift; done
scenes=("${@:2}")
((${#left_out[@]} > 0)) || left_out=("texture fog glass absorption")
((${#scenes[@]} > 0)) || scenes=(plain mirror light_color background scenes/highlights.txt)
if [[ ${left_out[*]} == all ]]; then
    mapfile -t left_out < <(sed -n 's/.*Self::[A-Za-z]* => "\([a-z_]*\)",/\1/p' src/effects/effect.rs)
fi

# The crates below are those of the tests, so that nothing but this crate is built anew; its own code is made as for a release.
settings=(opt-level=3 debug=false debug-assertions=false overflow-checks=false)
programs=target/idle_effects
mkdir -p "$programs"

# Builds a program without some effects, and prints its path.
program() {
    local built made="$programs/${1// /+}"
    built=$(ARCHETRACE_WITHOUT=$1 cargo build --quiet --locked --bench idle_effects --message-format=json \
        "${settings[@]/#/--config=profile.dev.package.archetrace.}")
    cp "$(sed -n 's/.*"name":"idle_effects".*"executable":"\([^"]*\)".*/\1/p' <<<"$built" | tail -1)" "${made}_program"
    echo "${made}_program"
}

instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" "$2" "$3" 2>&1 | sed -n 's/.*Collected : //p'
}

a_pixel() {
    local low high
    low=$(instructions "$1" $small "$2")
    high=$(instructions "$1" $large "$2")
    echo $(((high - low) / (large * large - small * small)))
}

asks_for_one_of() {
    local asked effect
    asked=" $("$whole" "$1") "
    for effect in $2; do [[ $asked == *" $effect "* ]] && return 0; done
    return 1
}

failures=0
fail() {
    echo "idle_effects: $*" >&2
    failures=$((failures + 1))
}

# One row of the table: a scene, and what the program costs it beyond that of a program without some effects.
compare() {
    local scene=$1 effects=$2 less=$3 with without
    if asks_for_one_of "$scene" "$effects"; then
        "$less" $small "$scene" >/dev/null 2>&1 && fail "$scene is traced without $effects"
        return 0
    fi
    [[ $("$whole" $small "$scene") == "$("$less" $small "$scene")" ]] || fail "$scene is another picture without $effects"
    with=$(a_pixel "$whole" "$scene") without=$(a_pixel "$less" "$scene")
    printf '| %s | %s | %d | %d | %s |\n' "$effects" "$scene" "$with" "$without" \
        "$(awk "BEGIN { printf \"%+.2f %%\", 100 * ($with / $without - 1) }")"
    awk "BEGIN { exit !($with <= $without * (1 + $bound)) }" || fail "$scene pays more than 1 % for $effects"
}

whole=$(program "")
echo '| without | scene | instructions a pixel | without it | difference |'
echo '|---|---|---|---|---|'
for effects in "${left_out[@]}"; do
    less=$(program "$effects")
    for scene in "${scenes[@]}"; do compare "$scene" "$effects" "$less"; done
done
exit $((failures > 0))
