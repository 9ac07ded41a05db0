#!/usr/bin/env bash
# Asks every simulator the grid of cases and writes data/record/engines.md. Usage: record.sh [OUT [NAME ..]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
"$here/environment.sh"
cargo build --quiet --release --manifest-path "$root/Cargo.toml" --example peers
PYTHONDONTWRITEBYTECODE=1 exec "$root/target/peers/venv/bin/python" "$here/record.py" "$@"
