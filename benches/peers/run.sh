#!/usr/bin/env bash
# Makes the virtual environment of the peers (target/peers/venv) and asks them and the oracles the same cases. Usage: run.sh [OUT]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
venv=$root/target/peers/venv
if ! cmp -s "$here/requirements.txt" "$venv/requirements.txt"; then
    python3 -m venv "$venv"
    "$venv/bin/pip" install --quiet --only-binary :all: -r "$here/requirements.txt"
    cp "$here/requirements.txt" "$venv/"
fi
cargo build --quiet --release --manifest-path "$root/Cargo.toml" --example peers
# One thread each; what numba and Python compile stays out of the source tree.
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1 NUMBA_CACHE_DIR=$root/target/peers/numba
exec "$venv/bin/python" "$here/run.py" "$@"
