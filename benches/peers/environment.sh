#!/usr/bin/env bash
# Makes what the engines of data/engines/peers.toml run in, pinned, under target/peers (about 2 GB); from the package registries only.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
place=$here/../../target/peers
if ! cmp -s "$here/requirements.txt" "$place/venv/requirements.txt"; then
    python3 -m venv "$place/venv"
    "$place/venv/bin/pip" install --quiet --no-cache-dir --only-binary :all: -r "$here/requirements.txt"
    cp "$here/requirements.txt" "$place/venv/"
fi
# Rapier is for Node.js, Siconos comes with the system's packages; a manifest that names what is not there says so.
[ -d "$place/node/node_modules/@dimforge/rapier2d-compat" ] || npm install --silent --no-audit --no-fund --prefix "$place/node" @dimforge/rapier2d-compat@0.21.0 ||
    echo "no Rapier: it needs npm and Node.js" >&2
dpkg-query --show python3-siconos > /dev/null 2>&1 || apt-get install -y --no-install-recommends python3-siconos > /dev/null ||
    echo "no Siconos: it needs Debian's package python3-siconos" >&2
