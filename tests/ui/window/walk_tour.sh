#!/bin/sh
# walk_tour.sh MANAGER WINDOW_SCREENSHOT FOLDER SIZE [light|dark]: goes through the guided tour on the
# present display and saves a picture of every step, FOLDER/tour_STEP_SIZE_COLOURS.png. Ends with the
# first step that is not alive.
set -e
manager=$1 program=$2 folder=$3 size=$4 colours=${5:-light}
mkdir -p "$folder"
"$manager" -use_titlebar no &
pid=$!
trap 'kill $pid' EXIT
set -- --do tour
[ "$colours" = light ] || set -- --dark "$@"
for step in 1 2 3 4 5 6; do
  "$program" "$folder/tour_${step}_${size}_$colours.png" --size "$size" --wait 300 "$@"
  set -- "$@" --do tourStepNext
done
