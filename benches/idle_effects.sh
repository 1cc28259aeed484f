#!/usr/bin/env bash
# What an effect costs a scene that does not ask for it: instructions of a frame, with the program as it is to those with a
# program from which the effect is compiled out, by valgrind. Two sizes are subtracted, so that what a process costs by
# itself drops out. Fails where they differ by more than 1 %, where a picture differs, where a program traces a scene that
# asks for what it was built without, and where nothing can be counted; and, too, where a scene without any effect does not
# take 1.25 times as much with the kernel that has them all.
#
# Usage: benches/idle_effects.sh [EFFECT... [-- SCENE...]]
# A program is built without each EFFECT; several in one word ("fog glass") are left out together, which is a harder test
# than each alone: only if a scene pays more than 1 % for a word does each of its effects get a program of its own. SCENE is
# a scene file or a picture of the gallery. Unless given: one word of some effects, and some scenes, which takes minutes.
# `all` stands for every pair of an effect and a scene without it, for every scene file and the whole gallery: for the words
# below, which hold each effect twice, each time beside others, so that whatever a scene asks for, some word tells of each
# effect that it does not. That takes an hour; the worst of each effect is summed up at the end.
# UNITS=N compiles in N parts instead of those of a release: what the compiler inlines depends on them, the rule does not.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
small=16 one_by_one=64 in_packets=320 bound=0.01 least_gain=1.25
all_words=("gloss mirror falloff spot_cone" "texture texture_filter checker_filter light_color"
    "directional area_light background fog" "glass absorption aperture exposure" "motion_blur srgb"
    "gloss texture directional glass motion_blur" "mirror texture_filter area_light absorption srgb"
    "falloff checker_filter background aperture" "spot_cone light_color fog exposure")
words=()
while (($# > 0)) && [[ $1 != -- ]]; do words+=("$1") && shift; done
scenes=("${@:2}")
# Nothing but this crate is built anew, with the crates of the tests; its own code is made as for a release.
settings=(opt-level=3 codegen-units="${UNITS:-4}" debug=false debug-assertions=false overflow-checks=false)
build=(cargo build --quiet --locked --bench idle_effects --message-format=json
    "${settings[@]/#/--config=profile.dev.package.archetrace.}")
is_all=0
if [[ ${words[*]} == all ]]; then
    is_all=1
    words=("${all_words[@]}")
    mapfile -t names < <(sed -n 's/.*Exhibit { *name: "\([a-z_]*\)".*/\1/p; s/^ *name: "\([a-z_]*\)",$/\1/p' \
        scenes/gallery/exhibits.rs)
    ((${#scenes[@]} > 0)) || scenes=("${names[@]}" scenes/*.txt)
    # Many programs: those without a window are built sooner.
    build+=(--no-default-features)
fi
((${#words[@]} > 0)) || words=("texture fog glass absorption")
((${#scenes[@]} > 0)) || scenes=(plain mirror light_color background scenes/highlights.txt)

# Some machines' C libraries copy and clear kilobytes by an instruction that valgrind counts once a byte.
export GLIBC_TUNABLES=glibc.cpu.x86_rep_movsb_threshold=1073741824:glibc.cpu.x86_rep_stosb_threshold=1073741824

programs=target/idle_effects
mkdir -p "$programs"

# Builds a program without some effects, for the instructions that every processor has: the same figures on each, and
# valgrind knows them all. Its path is in `built` then.
program() {
    local messages
    built="$programs/without_${1// /+}"
    messages=$(ARCHETRACE_WITHOUT=$1 ARCHETRACE_SIMD=baseline CARGO_INCREMENTAL=0 "${build[@]}")
    # Without what debuggers want, which valgrind would read through each time.
    strip --strip-debug -o "$built" "$(sed -n 's/.*"name":"idle_effects".*"executable":"\([^"]*\)".*/\1/p' <<<"$messages" | tail -1)"
}

instructions() {
    local said
    # Valgrind stops at instructions that it does not know: what it has counted until then is no figure.
    if ! said=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1); then
        echo "$0: valgrind cannot run $1" >&2
        kill $$
    fi
    sed -n 's/.*Collected : //p' <<<"$said"
}

# The larger size by scene. A process varies by some ten thousand instructions from one time to the next: a picture must be
# many times that, and packets take few.
declare -A size

a_pixel() {
    local program=$1 scene=$2 large=${size[$2]} low high
    shift 2
    low=$(instructions "$program" $small "$scene" "$@")
    high=$(instructions "$program" "$large" "$scene" "$@")
    awk "BEGIN { printf \"%.1f\", ($high - $low) / ($large * $large - $small * $small) }"
}

# Counts for some scenes, on all processors; the figures are in `counted` then, by scene.
declare -A counted
count() {
    local less=$1 scene place
    place=$(mktemp -d)
    shift
    for scene; do
        while (($(jobs -rp | wc -l) >= $(nproc))); do wait -n; done
        a_pixel "$less" "$scene" >"$place/${scene//\//+}" &
    done
    wait
    for scene; do counted[$scene]=$(<"$place/${scene//\//+}"); done
    rm -r "$place"
}

failures=0
fail() {
    echo "idle_effects: $*" >&2
    failures=$((failures + 1))
}

# Whether one of some effects is among others.
meets() {
    local effect
    for effect in $1; do [[ " $2 " == *" $effect "* ]] && return 0; done
    return 1
}

# Whether all of them are.
is_within() {
    local effect
    for effect in $1; do [[ " $2 " == *" $effect "* ]] || return 1; done
}

# What a scene asks for, what the program as it is takes for it, and the effects that are known to cost it nothing.
declare -A asked full idle
# What an effect costs most, in hundredths of a percent, where, and in how many rows it was looked for.
declare -A worst where rows

# Notes a difference for each effect that was left out.
note() {
    local effect
    for effect in $2; do
        rows[$effect]=$((${rows[$effect]:-0} + 1))
        if [[ -z ${worst[$effect]:-} ]] || (($3 > ${worst[$effect]})); then
            worst[$effect]=$3 where[$effect]="$1 | $2"
        fi
    done
}

percent() {
    awk "BEGIN { printf \"%+.2f %%\", $1 / 100 }"
}

# One row of the table: a scene, and what the program costs it beyond that of one without some effects. Succeeds unless
# that is too much.
compare() {
    local scene=$1 effects=$2 less=$3 without=${counted[$1]} more
    [[ $("$whole" $small "$scene") == "$("$less" $small "$scene")" ]] || fail "$scene is another picture without $effects"
    more=$(awk "BEGIN { printf \"%.0f\", 10000 * (${full[$scene]} / $without - 1) }")
    echo "| $effects | $scene | ${full[$scene]} | $without | $(percent "$more") |"
    awk "BEGIN { exit !(${full[$scene]} <= $without * (1 + $bound)) }" || return 1
    note "$scene" "$effects" "$more"
}

# Holds every scene against a program without some effects; those that pay for them are held against each alone.
try() {
    local effects=$1 less scene idle_scenes=() paying=()
    program "$effects" && less=$built
    for scene in "${scenes[@]}"; do
        if meets "$effects" "${asked[$scene]}"; then
            if "$less" $small "$scene" >/dev/null 2>&1; then fail "$scene is traced without $effects"; fi
        elif ! is_within "$effects" "${idle[$scene]}"; then
            idle_scenes+=("$scene")
        fi
    done
    count "$less" "${idle_scenes[@]}"
    for scene in "${idle_scenes[@]}"; do
        if compare "$scene" "$effects" "$less"; then
            idle[$scene]+=" $effects"
        else
            paying+=("$scene")
        fi
    done
    rm "$less"
    ((${#paying[@]} > 0)) || return 0
    if [[ $effects == *" "* ]]; then
        local scenes=("${paying[@]}") effect
        for effect in $effects; do try "$effect"; done
    else
        for scene in "${paying[@]}"; do fail "$scene pays more than 1 % for $effects"; done
    fi
}

program "" && whole=$built
for scene in plain "${scenes[@]}"; do
    asked[$scene]=$("$whole" "$scene") idle[$scene]=""
    if is_within "${asked[$scene]}" "gloss mirror texture falloff spot_cone motion_blur srgb"; then
        size[$scene]=$in_packets
    else
        size[$scene]=$one_by_one
    fi
done
count "$whole" "${scenes[@]}"
for scene in "${scenes[@]}"; do full[$scene]=${counted[$scene]}; done
plain=$(a_pixel "$whole" plain) everything=$(a_pixel "$whole" plain everything)
echo "A scene without effects: $plain instructions a pixel, $everything with the kernel that has them all."
awk "BEGIN { exit !($everything >= $least_gain * $plain) }" || fail "a scene without effects gains too little"
echo
echo '| without | scene | instructions a pixel | without it | difference |'
echo '|---|---|---|---|---|'
for effects in "${words[@]}"; do try "$effects"; done
if ((is_all)); then
    for scene in "${scenes[@]}"; do
        for effect in ${all_words[*]:0:5}; do
            meets "$effect" "${asked[$scene]} ${idle[$scene]}" || fail "$scene: nothing tells what $effect costs"
        done
    done
    printf '\n| effect | scenes | costs them at most | that is | left out with it |\n|---|---|---|---|---|\n'
    for effect in ${all_words[*]:0:5}; do
        [[ -z ${worst[$effect]:-} ]] ||
            echo "| $effect | ${rows[$effect]} | $(percent "${worst[$effect]}") | ${where[$effect]} |"
    done
fi
exit $((failures > 0))
