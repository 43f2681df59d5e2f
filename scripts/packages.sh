# The Debian packages of this project, to be sourced.

# To build and run.
build_packages=(g++ cmake ninja-build pkg-config libfmt-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libhwloc-dev
  libxxhash-dev libstb-dev libopenexr-dev libboost-dev libeigen3-dev libhwy-dev libgmp-dev libmuparserx-dev)
# Each of these may be missing; what it brings is then missing too. OpenMP on libgomp comes with g++; clang and libomp-dev
# build the same schedulers for LLVM's runtime. zlib1g-dev is Assimp's: its package links to it without depending on it.
# Python's two draw the charts of scripts/chart_study; Vega, what bundles it and what runs it, those of scripts/draw_report.
optional_packages=(libtbb-dev clang libomp-dev libassimp-dev zlib1g-dev libbenchmark-dev libembree-dev
  python3-matplotlib python3-jinja2 node-vega esbuild nodejs librsvg2-bin)
# Chromium opens the page of scripts/draw_report in a test, which is skipped without it; xz packs and unpacks recorded runs.
test_packages=(libgtest-dev chromium xz-utils)
# What .ci/run and .ci/long check beyond the tests.
check_packages=(clang-format clang-tidy)
