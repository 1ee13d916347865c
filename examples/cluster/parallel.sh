#!/usr/bin/env bash
# A batch by GNU parallel, eight shards, here on this machine; --sshlogin spreads them over others that share the
# directory. The same command goes on after an interruption.
#
#   examples/cluster/parallel.sh model.ndjson results
set -eu
export EXSECT=${EXSECT:-exsect}
mkdir -p "$2"
# Status 3, some pair is incomplete or failed, is an answer.
parallel "$EXSECT batch $1 --shard {}/8 --jobs 1 --output $2/{}.ndjson --resume --quiet || [ \$? -eq 3 ]" ::: {1..8}
"$EXSECT" batch-merge "$2"/[1-8].ndjson --output "$2/all.ndjson" || [ $? -eq 3 ]
