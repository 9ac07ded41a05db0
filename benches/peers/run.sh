#!/usr/bin/env bash
# Asks the peers and the project's own oracles the same cases and times them. Usage: run.sh [OUT]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
"$here/environment.sh"
cargo build --quiet --release --manifest-path "$root/Cargo.toml" --example peers
PYTHONDONTWRITEBYTECODE=1 exec "$root/target/peers/venv/bin/python" "$here/run.py" "$@"
