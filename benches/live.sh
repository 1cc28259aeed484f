#!/usr/bin/env bash
# How many traced pictures a second the window shows while the camera turns: the scene of benches/s0 in a window of
# 768 x 768 on a display without a screen, in f32 and f64. Each turn waits for the complete picture of one sample a pixel
# of the one before, so that its way through the display server and the window's own drawing (in software here) count, too.
#
# Usage: benches/live.sh [TURNS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
turns=${1:-200} side=768
cargo build --release --quiet --locked
folder=$(mktemp -d)
# Everything started here ends with this script.
trap 'kill $(jobs -p) 2>/dev/null; rm -rf "$folder"' EXIT

mkfifo "$folder/display"
Xvfb -displayfd 1 -screen 0 1280x1024x24+32 -nolisten tcp -noreset >"$folder/display" 2>/dev/null &
read -r number <"$folder/display"
export DISPLAY=:$number

# Reads events up to one that has all the words given.
await() {
    local line word found
    while read -r line <&"$events"; do
        found=1
        for word in "$@"; do [[ $line == *"$word"* ]] || found=0; done
        ((found)) && return 0
    done
    echo "live.sh: the window is gone" >&2
    exit 1
}

measure() {
    local window start end
    # shellcheck disable=SC2046
    exec {events}< <(exec target/release/archetrace view benches/s0/scene.txt $(<benches/s0/scene.cam) \
        --precision "$1" --print-events --print-camera --out "$folder")
    await '"ready"'
    window=$(xdotool search --onlyvisible --name archetrace | tail -1)
    xdotool windowsize "$window" $side $side windowfocus "$window"
    await '"resized"' "\"side\":$side"
    exec {hands}> >(exec xdotool -)
    # Without the strip: what accuracy costs is not measured meanwhile.
    echo "key i" >&"$hands"
    await '"strip"'
    echo "key t" >&"$hands"
    await '"picture"' '"is_final":true'
    start=$EPOCHREALTIME
    for ((turn = 0; turn < turns; turn++)); do
        echo "key --delay 2 $((turn / 10 % 2 + 1))" >&"$hands"
        await '"pos"'
        await '"picture"'
    done
    end=$EPOCHREALTIME
    awk "BEGIN { printf \"| %s | %.1f | %.1f |\\n\", \"$1\", $turns / ($end - $start), 1000 * ($end - $start) / $turns }"
    echo "key ctrl+q" >&"$hands"
    # It ends before its display does.
    cat <&"$events" >/dev/null
    exec {hands}>&- {events}<&-
}

echo "| precision | pictures a second, $side x $side | ms a picture |"
echo '|---|---|---|'
measure f32
measure f64
