#!/usr/bin/env bash
# Whole processes side by side, from start to file: archetrace, POV-Ray and tachyon on the same scene, in interleaved
# rounds. Prints seconds on the wall (median, least, most), processor seconds (median), and the median of the ratios to
# archetrace in f32 round by round, by processor time: on a machine with other work that is the firm figure.
#
# Usage: benches/peers.sh [FOLDER [ROUNDS]]
# The folder has scene.txt, scene.cam (flags of our camera), scene.pov and scene.dat; benches/s0 unless given.
# Debian's packages povray and tachyon are installed where that can be done.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=${1:-benches/s0}
rounds=${2:-5}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

for program in povray tachyon; do
    command -v "$program" >/dev/null && continue
    if ((EUID == 0)); then
        apt-get update -qq && apt-get install -y -qq --no-install-recommends "$program" >/dev/null
    else
        echo "benches/peers.sh: $program is missing" >&2
        exit 1
    fi
done
cargo build --release --quiet --locked

pixels=$(sed -n 3p "$folder/scene.txt")
read -ra camera <"$folder/scene.cam"

ours() { target/release/archetrace render "$folder/scene.txt" "${camera[@]}" -o "$out/a.bmp" --threads 2 "$@"; }
run_f32() { ours --precision f32; }
run_f64() { ours --precision f64; }
run_povray() { povray "+I$folder/scene.pov" "+W$pixels" "+H$pixels" -A +WT2 -D "+O$out/p.png"; }
run_tachyon() { tachyon "$folder/scene.dat" -numthreads 2 -res "$pixels" "$pixels" -o "$out/t.tga"; }

programs=(f32 f64 povray tachyon)
TIMEFORMAT='%R %U %S'
for ((round = 0; round < rounds; round++)); do
    for program in "${programs[@]}"; do
        { time "run_$program" >/dev/null 2>&1; } 2>>"$out/$program.times"
    done
done

echo "| whole process, 2 threads | wall s (least-most) | processor s | times archetrace f32 (least-most) |"
echo "|---|---|---|---|"
for program in "${programs[@]}"; do
    paste -d' ' "$out/f32.times" "$out/$program.times" | awk -v name="$program" '
        function sorted(values, count,    i, j, v) {
            for (i = 2; i <= count; i++)
                for (j = i; j > 1 && values[j] < values[j - 1]; j--) {
                    v = values[j]; values[j] = values[j - 1]; values[j - 1] = v
                }
        }
        { wall[NR] = $4; cpu[NR] = $5 + $6; ratio[NR] = ($5 + $6) / ($2 + $3) }
        END {
            sorted(wall, NR); sorted(cpu, NR); sorted(ratio, NR); m = int((NR + 1) / 2)
            printf "| %s | %.3f (%.3f-%.3f) | %.3f | %.1f (%.1f-%.1f) |\n", name, wall[m], wall[1], wall[NR], cpu[m],
                ratio[m], ratio[1], ratio[NR]
        }'
done
