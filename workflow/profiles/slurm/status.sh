#!/usr/bin/env bash
# Usage: status.sh JOB. Says running, success or failed, as Snakemake wants it.
state=$(scontrol show job "$1" 2> /dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p')
[ -n "$state" ] || state=$(sacct -X -n -o State -j "$1" 2> /dev/null | awk 'NR == 1 {print $1}')
case "$state" in
  PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | REQUEUED | '') echo running ;;
  COMPLETED) echo success ;;
  *) echo failed ;;
esac
