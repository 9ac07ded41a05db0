//! An answer as one HTML file: what it is in short, a drawing, and a table.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::{head, without_controls};

/// What is on the page.
pub struct Answer<'a> {
    /// What was asked.
    pub title: &'a str,
    /// What came out in short: what each thing is called, and what it is.
    pub facts: &'a [(&'a str, String)],
    /// The drawing, an SVG of ours.
    pub svg: &'a str,
    /// What the rows are.
    pub caption: &'a str,
    /// Over each column.
    pub columns: &'a [&'a str],
    /// A row for each line.
    pub rows: &'a [Vec<String>],
    /// What made it.
    pub foot: &'a str,
}

/// The page of an answer, which needs no other file and no network.
pub fn answer(answer: &Answer) -> String {
    let Answer { title, facts, svg, caption, columns, rows, foot } = answer;
    // The drawing comes with a style of its own.
    let style = svg.split_once("<style>").and_then(|(_, rest)| rest.split_once("</style>")).map(|(style, _)| style);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            (head::head(title, style))
            body {
                header {
                    p .product { "chattercheck" }
                    h1 { (title) }
                    dl { @for (name, what) in *facts { dt { (name) } dd { (what) } } }
                }
                main {
                    figure .drawing { (PreEscaped(*svg)) }
                    (table(caption, columns, rows))
                }
                footer { (foot) }
            }
        }
    };
    without_controls(&page.into_string())
}

fn table(caption: &str, columns: &[&str], rows: &[Vec<String>]) -> Markup {
    html! {
        h2 { (caption) }
        div .scroll tabindex="0" {
            table {
                thead { tr { @for column in columns { th scope="col" { (column) } } } }
                tbody { @for row in rows { tr { @for cell in row { td .number { (cell) } } } } }
            }
        }
    }
}
