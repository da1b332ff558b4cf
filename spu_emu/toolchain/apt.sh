# apt-get as our scripts call it. Sourced.

# patient_apt_get ARGUMENT...: waits up to ten minutes for another process that has apt or dpkg locked. apt-get waits for
# dpkg's lock by itself, for that of its lists it does not.
patient_apt_get() {
  local give_up=$((SECONDS + 600)) words told=
  while ! words=$(apt-get -o DPkg::Lock::Timeout=600 "$@" 2>&1); do
    if [ $SECONDS -ge $give_up ] || ! grep -q 'Could not get lock' <<<"$words"; then
      printf '%s\n' "$words" >&2
      return 1
    fi
    [ -n "$told" ] || printf 'another process has apt locked; waiting for it\n' >&2
    told=1
    sleep "${SPU_EMU_APT_PAUSE:-3}"
  done
  [ -z "$words" ] || printf '%s\n' "$words" >&2
}
