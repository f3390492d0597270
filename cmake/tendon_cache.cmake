# Sets TENDON_CACHE to the folder in which tools/setup keeps the libraries that it builds for this user. The same as in
# tools/common.sh.
set(TENDON_CACHE "$ENV{XDG_CACHE_HOME}")
if(NOT TENDON_CACHE)
  set(home "$ENV{HOME}")
  if(NOT home)
    set(home /tmp)
  endif()
  set(TENDON_CACHE ${home}/.cache)
endif()
string(APPEND TENDON_CACHE /tendon)
