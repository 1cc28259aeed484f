#!/usr/bin/env bash
# Prints README's table "What accuracy costs": rays and instructions a pixel of one scene at each setting.
# Instructions are counted by valgrind, which repeats to the instruction; two sizes are subtracted, so that what a
# process costs by itself drops out. Usage: benches/accuracy.sh [SCENE]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scene=${1:-scenes/official.txt}
small=128 large=256
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cargo build --release --quiet

render() { target/release/archetrace render "$scene" -o "$folder/picture.bmp" --threads 1 "$@"; }

instructions() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null \
        target/release/archetrace render "$scene" -o "$folder/picture.bmp" --threads 1 "$@" 2>&1 |
        sed -n 's/.*Collected : //p'
}

# Rays come before rows in the file, and a row of mirrors is named like a ray.
ray_count() { sed -n "/\"$1\": /{s/.*: \([0-9]*\).*/\1/p;q}" "$folder/stats.json"; }

per_pixel() { awk "BEGIN { printf \"%.2f\", $1 / ($large * $large) }"; }

row() {
    local low high
    render --size $large --stats "$folder/stats.json" "$@"
    low=$(instructions --size $small "$@")
    high=$(instructions --size $large "$@")
    printf '| `%s` | %s | %s | %d |\n' "$*" "$(per_pixel "$(ray_count shadow)")" "$(per_pixel "$(ray_count mirror)")" \
        $(((high - low) / (large * large - small * small)))
}

echo '| setting | shadow rays a pixel | mirror rays a pixel | instructions a pixel |'
echo '|---|---|---|---|'
for level in 1 2 3 4 8; do row --level $level; done
row --level 3 --precision f32
row --level 3 --texture
