#!/usr/bin/env bash
# Measures every row of this folder again: into runs/, where an interrupted measurement goes on.
# Times are worth something only if the machine does nothing else meanwhile.
# resnet18 and alexnet have no rows: their weights have to be downloaded first (vpr-bench weights fetch).
set -euo pipefail
cd "$(dirname "$0")/.."

thumbnails=nordland:64x32
simulated=(gardens berlin-a100 berlin-halenseestrasse berlin-kudamm amstertime st-lucia nordland)

measure() { vpr-bench run "$@"; } # one process each, so that none has another's memory

for dataset in gardens "${simulated[@]/%/:simulated}"; do
  for method in random hog sad sift efficientnet-lite0 twostage; do
    measure --method "$method" --dataset "$dataset" --protocol all
  done
  for method in seqslam hmm; do
    measure --method "$method" --param inner=efficientnet-lite0 --dataset "$dataset" --protocol all
  done
done
measure --method twostage --param n_components=1 --dataset gardens --protocol all
for method in random hog sad sift efficientnet-lite0 twostage; do measure --method "$method" --dataset "$thumbnails"; done
for method in seqslam hmm; do measure --method "$method" --param inner=sad --dataset "$thumbnails"; done

vpr-bench leaderboard
vpr-bench gate --baseline leaderboards/baseline.json --update
