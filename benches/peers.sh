#!/usr/bin/env bash
# archetrace beside POV-Ray, tachyon and Embree: the tables of README's "How fast", in interleaved rounds of one run.
#
# Usage: benches/peers.sh [s0] [process] [rays] [million]
# All parts unless some are named. ROUNDS=5 says how often, LARGE_ROUNDS=2 for pictures of a million spheres (POV-Ray takes
# most of a minute for one). LIMIT="COMMAND" names another limit program, which prints lines "cpu_ms NUMBER" and "ms NUMBER".
#
#   s0       the picture of benches/s0, 1024 x 1024: tracing alone, beside benches/limit.cpp, too
#   process  the same from start to file
#   rays     1e3 to 1e6 spheres: millions of rays a second by kind, beside Embree's fastest way of each round
#   million  a million spheres: loading, building, memory, one edit (of 1e5), and the whole picture
#
# Embree is asked for one ray, eight or sixteen at once, with spheres of its own ("points") and with spheres by a callback of
# ours ("user"), which tests as many rays at once.
#
# Every number is a median with the least and the most in brackets. "times" are ratios within a round: they mean something
# where milliseconds do not, because other work on the machine slows everybody down. Debian's packages povray, tachyon,
# libembree-dev and g++ are installed where that can be done.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
rounds=${ROUNDS:-5} large_rounds=${LARGE_ROUNDS:-2}
parts=("$@")
((${#parts[@]} > 0)) || parts=(s0 process rays million)
s0=benches/s0
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# ---- what is needed ----

needed=(povray tachyon libembree-dev g++)
missing=()
for package in "${needed[@]}"; do
    dpkg-query --show "$package" >/dev/null 2>&1 || missing+=("$package")
done
if ((${#missing[@]} > 0)); then
    ((EUID == 0)) || { echo "benches/peers.sh: these Debian packages are missing: ${missing[*]}" >&2; exit 1; }
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi

cargo build --release --quiet --locked --bins --example spheres
archetrace=target/release/archetrace spheres=target/release/examples/spheres
bench_program() {
    cargo bench --quiet --locked --no-run --bench "$1" --message-format json |
        sed -n "s/.*\"name\":\"$1\".*\"executable\":\"\([^\"]*\)\".*/\1/p"
}
embree=$out/embree
g++ -O3 -march=native -std=c++17 benches/embree.cpp -o "$embree" -lembree3 -lpthread
g++ -O3 -march=native -mprefer-vector-width=512 -ffast-math -fno-finite-math-only -mrecip=all -std=c++17 \
    benches/limit.cpp -o "$out/limit" -lpthread
limit=${LIMIT:-$out/limit $s0/scene.txt $(cat $s0/scene.cam) --repeats 15}

# ---- measuring ----

# Keeps a measurement: one file a name, one line a round.
record() { echo "$2" >>"$out/$1.values"; }

# Keeps wall and processor seconds of a command.
record_process() {
    local name=$1 TIMEFORMAT='%R %U %S' times
    shift
    times=$({ time "$@" >/dev/null 2>&1; } 2>&1)
    read -r wall user sys <<<"$times"
    record "$name.wall" "$wall"
    record "$name.cpu" "$(awk "BEGIN { print $user + $sys }")"
}

# A number of a JSON line on standard input.
json_number() { sed -n "s/.*\"$1\":\([0-9.e+-]*\).*/\1/p"; }

camera() { cat "$1/scene.cam"; }

# Prints "median (least-most)" of the values of a name, or of their ratios to those of a second name.
spread() {
    local name=$1 reference=${2:-}
    [[ -e $out/$name.values ]] || { echo "-"; return; }
    if [[ -n $reference ]]; then paste "$out/$name.values" "$out/$reference.values"; else cat "$out/$name.values"; fi |
        awk '{ print (NF > 1 ? $1 / $2 : $1) }' | sort -g |
        awk 'function short(x) { return sprintf(x < 999.5 ? "%.3g" : "%.0f", x) }
            { v[NR] = $1 } END { print short(v[int((NR + 1) / 2)]) " (" short(v[1]) "-" short(v[NR]) ")" }'
}

# Keeps milliseconds on the wall and of the processors.
record_both() {
    record "$1" "$2"
    record "$1.cpu" "$3"
}

povray_args() { echo "+I$1/scene.pov +W$2 +H$2 -A +WT2 -D +O$out/p.png"; }
tachyon_args() { echo "$1/scene.dat -numthreads 2 -res $2 $2 -o $out/t.tga"; }
# Milliseconds that they say they traced for, on the wall and of the processors; tachyon tells the former only.
povray_trace() {
    # shellcheck disable=SC2046 # words on purpose
    povray $(povray_args "$1" "$2") 2>&1 | tr '()' '  ' |
        awk '/Trace Time:/ { printf "%s ", 1000 * $(NF - 1); getline; for (i = 1; i < NF; i++) if ($i == "with") print 1000 * $(i + 1) }'
}
tachyon_trace() {
    # shellcheck disable=SC2046
    tachyon $(tachyon_args "$1" "$2") 2>&1 | tr '\r' '\n' |
        sed -n 's/.*Ray Tracing Time: *\([0-9.]*\) seconds.*/\1/p' | awk '{ print 1000 * $1 }'
}
# Those of our traced frame, warm.
frame_trace() {
    # shellcheck disable=SC2046
    "$frame" "$1/scene.txt" $(camera "$1") "${@:2}" >"$out/frame"
    echo "$(json_number ms_median <"$out/frame") $(json_number cpu_ms_median <"$out/frame")"
}
# Those of Embree's fastest way, of what it printed: with spheres of its own (points), or by a callback of ours (user).
embree_trace() {
    awk -v mode="$1" 'index($1, "frame_" mode) == 1 { wall = $2 } index($1, "cpu_frame_" mode) == 1 { print wall, $2 }' |
        sort -g | head -1
}

# ---- the parts ----

# shellcheck disable=SC2046
run_s0() {
    local frame size precision label name
    frame=$(bench_program frame)
    size=$(sed -n 3p $s0/scene.txt)
    for ((round = 0; round < rounds; round++)); do
        for precision in f32 f64; do
            record_both $precision $(frame_trace $s0 --threads 2 --precision $precision)
            record_both $precision.one $(frame_trace $s0 --threads 1 --precision $precision)
        done
        record_both limit $($limit | awk '/^cpu_ms/ { cpu = $2 } /^ms/ { wall = $2 } END { print wall, cpu }')
        "$embree" $s0/scene.txt $(camera $s0) --repeats 3 >"$out/embree_frames"
        record_both embree.points $(embree_trace points <"$out/embree_frames")
        record_both embree.user $(embree_trace user <"$out/embree_frames")
        record tachyon "$(tachyon_trace $s0 "$size")"
        record_both povray $(povray_trace $s0 "$size")
    done
    echo "| S0, $size x $size, tracing, 2 threads | ms | processor ms | times f32 | times f64 | times f32, processor | times f64, processor |"
    echo "|---|---|---|---|---|---|---|"
    for name in f32 f64 limit embree.points embree.user tachyon povray; do
        printf '| %s | %s | %s | %s | %s | %s | %s |\n' $name "$(spread $name)" "$(spread $name.cpu)" "$(spread $name f32)" \
            "$(spread $name f64)" "$(spread $name.cpu f32.cpu)" "$(spread $name.cpu f64.cpu)"
    done
    echo
    echo "2 threads against 1: f32 $(spread f32.one f32), f64 $(spread f64.one f64) times as fast"
    echo
}

run_process() {
    local size
    size=$(sed -n 3p $s0/scene.txt)
    # shellcheck disable=SC2046
    for ((round = 0; round < rounds; round++)); do
        for precision in f32 f64; do
            record_process "process.$precision" $archetrace render $s0/scene.txt $(camera $s0) --threads 2 \
                --precision $precision -o "$out/a.bmp"
        done
        record_process process.tachyon tachyon $(tachyon_args $s0 "$size")
        record_process process.povray povray $(povray_args $s0 "$size")
    done
    process_table "S0, start to file, 2 threads" process f32 f64 tachyon povray
}

# A table of whole processes, compared with the first: a title, a prefix of names, and the names.
process_table() {
    local title=$1 prefix=$2 first=$3 name
    shift 2
    echo "| $title | wall s | processor s | times $first, wall | times $first, processor |"
    echo "|---|---|---|---|---|"
    for name in "$@"; do
        printf '| %s | %s | %s | %s | %s |\n' "$name" "$(spread "$prefix.$name.wall")" "$(spread "$prefix.$name.cpu")" \
            "$(spread "$prefix.$name.wall" "$prefix.$first.wall")" "$(spread "$prefix.$name.cpu" "$prefix.$first.cpu")"
    done
    echo
}

# The greatest number of the lines that begin so.
fastest() { grep -E "^$1" | awk '{ print $2 }' | sort -gr | head -1; }

run_rays() {
    local rays count folder kind precision
    local kinds=(primary shadow mirror random)
    rays=$(bench_program rays)
    echo "| spheres, 2 threads | kind | f32, millions of rays a s | Embree's fastest way | f32 / Embree | f32 / Embree but for packets by callback | f64 / f32 |"
    echo "|---|---|---|---|---|---|---|"
    for count in 1000 10000 100000 1000000; do
        folder=$out/$count
        $spheres $count 1024 "$folder"
        # shellcheck disable=SC2046
        for ((round = 0; round < rounds; round++)); do
            for precision in f32 f64; do
                "$rays" "$folder/scene.txt" $(camera "$folder") --size 512 --threads 2 --precision $precision --repeats 1 >"$out/rays"
                for kind in "${kinds[@]}"; do
                    record "$count.$kind.$precision" \
                        "$(grep "\"class\":\"$kind\"" "$out/rays" | json_number mrays | sort -gr | head -1)"
                done
            done
            "$embree" "$folder/scene.txt" $(camera "$folder") --size 512 --what rays --repeats 1 >"$out/rays"
            for kind in "${kinds[@]}"; do
                record "$count.$kind.embree" "$(fastest "${kind}_(points|user)" <"$out/rays")"
                record "$count.$kind.embree.plain" "$(fastest "${kind}_(points|user1 )" <"$out/rays")"
            done
        done
        for kind in "${kinds[@]}"; do
            printf '| %s | %s | %s | %s | %s | %s | %s |\n' "$count" "$kind" "$(spread "$count.$kind.f32")" \
                "$(spread "$count.$kind.embree")" "$(spread "$count.$kind.f32" "$count.$kind.embree")" \
                "$(spread "$count.$kind.f32" "$count.$kind.embree.plain")" "$(spread "$count.$kind.f64" "$count.$kind.f32")"
        done
    done
    echo
}

run_million() {
    local million precision folder=$out/picture
    million=$(bench_program million)
    for ((round = 0; round < rounds; round++)); do
        for precision in f32 f64; do
            "$million" 1000000 1 $precision | while read -r name value; do record "million.$precision.$name" "$value"; done
        done
        "$million" 100000 1 f32 | awk '/^edit / { print $2 }' | sort -g | sed -n 10p >>"$out/edit.values"
    done
    echo "| a million spheres, 2 threads | f32 | f64 |"
    echo "|---|---|---|"
    for name in parse spawn extract build in_all; do
        echo "| $name, ms | $(spread million.f32.$name) | $(spread million.f64.$name) |"
    done
    echo "| bytes an entity beyond the World's own | $(spread million.f32.bytes) | $(spread million.f64.bytes) |"
    echo "| one of 1e5 moved: tables and tree ready again, ms | $(spread edit) | |"
    echo
    $spheres 1000000 1024 "$folder"
    # shellcheck disable=SC2046
    for ((round = 0; round < large_rounds; round++)); do
        for precision in f32 f64; do
            record_process "picture.$precision" $archetrace render "$folder/scene.txt" $(camera "$folder") --threads 2 \
                --precision $precision -o "$out/a.bmp"
        done
        record_process picture.tachyon tachyon $(tachyon_args "$folder" 1024)
        record_process picture.povray povray $(povray_args "$folder" 1024)
    done
    process_table "a million spheres, 1024 x 1024, start to file, 2 threads" picture f32 f64 tachyon povray
}

# ---- all of it ----

echo "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1), $(nproc) processors, load $(cut -d' ' -f1-3 /proc/loadavg), $(date -u +%F)"
echo
for part in "${parts[@]}"; do
    "run_$part"
done
