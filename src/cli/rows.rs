//! Rows of a record: for people, as a table in Markdown, or as JSON.

use clap::ValueEnum;
use comfy_table::{Table, presets};
use serde::Serialize;

/// How they are printed.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Text,
    Markdown,
    Json,
}

impl Format {
    /// The rows under a head; of each row the cells that people see.
    ///
    /// # Errors
    /// When a row can't be written as JSON.
    pub fn rows<Row: Serialize, const N: usize>(
        self,
        head: [&str; N],
        rows: &[Row],
        cells: impl Fn(&Row) -> [String; N],
    ) -> serde_json::Result<String> {
        Ok(match self {
            Self::Json => serde_json::to_string_pretty(rows)? + "\n",
            Self::Markdown => {
                let mut out = format!("| {} |\n| {} |\n", head.join(" | "), head.map(|_| "---").join(" | "));
                for row in rows {
                    out += &format!("| {} |\n", cells(row).map(|cell| cell.replace('|', "\\|")).join(" | "));
                }
                out
            }
            Self::Text => {
                let mut table = Table::new();
                table.load_preset(presets::NOTHING);
                table.set_header(head);
                for row in rows {
                    table.add_row(cells(row));
                }
                format!("{table}\n")
            }
        })
    }
}
