# The Debian packages of this project, to be sourced.

# To build and run.
build_packages=(g++ cmake ninja-build pkg-config libfmt-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libhwloc-dev
  libxxhash-dev libstb-dev libopenexr-dev)
# Each of these may be missing; what it brings is then missing too. OpenMP comes with g++. zlib1g-dev is Assimp's: its
# package links to it without depending on it.
optional_packages=(libtbb-dev libassimp-dev zlib1g-dev)
test_packages=(libgtest-dev)
# What .ci/run checks beyond the tests.
check_packages=(clang clang-format clang-tidy libomp-dev)
