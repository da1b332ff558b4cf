# What the parts of the toolchain's build share: messages, and stages that are done once. Sourced by build.

say() { printf '%s\n' "$*" >&2; }

fail() {
  say "error: $*"
  exit 1
}

hash_of() { sha256sum | cut -c 1-16; }

# stage NAME KEY: runs stage_NAME, which may go on with what an interrupted run with the same key left behind; when the
# key is another, reset_NAME clears that first. A stage that was finished with this key is passed over. Not to be called
# in a condition.
stage() {
  local name=$1 key=$2 log=$work/logs/$1.log begun=$work/stamps/$1.begun done=$work/stamps/$1.done
  local started=$SECONDS status
  [ "$(cat "$done" 2>/dev/null)" = "$key" ] && return 0
  rm -f "$done"
  printf '%-10s ' "$name" >&2
  if [ "$(cat "$begun" 2>/dev/null)" != "$key" ]; then
    "reset_$name"
    printf '%s\n' "$key" >"$begun"
  fi
  # Not in a condition: there the shell would not stop the stage at its first error.
  set +e
  (set -e && "stage_$name") >"$log" 2>&1 9>&-
  status=$?
  set -e
  if [ "$status" -ne 0 ]; then
    say "failed after $((SECONDS - started)) s; the last lines of $log:"
    tail -n 15 "$log" >&2
    exit 1
  fi
  printf '%s\n' "$key" >"$done"
  say "$((SECONDS - started)) s"
}
