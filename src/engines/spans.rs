//! Where the fields of an engine stand in its manifest, for what is said about them.

use std::ops::Range;

use contract::Invalid;
use toml::Spanned;

use super::table;

/// Where the fields of an engine stand; those that are missing, where the engine does.
pub struct Spans {
    pub name: Range<usize>,
    pub run: Range<usize>,
    pub directory: Range<usize>,
    pub version: Range<usize>,
    pub start_timeout: Range<usize>,
    pub case_timeout: Range<usize>,
    pub grace: Range<usize>,
    pub processes: Range<usize>,
    pub may_decline: Range<usize>,
    pub tolerance: Range<usize>,
}

impl Spans {
    pub fn of(table: &table::Table, whole: &Range<usize>) -> Self {
        fn of<T>(field: Option<&Spanned<T>>, whole: &Range<usize>) -> Range<usize> {
            field.map_or_else(|| whole.clone(), Spanned::span)
        }
        Self {
            name: table.name.span(),
            run: table.run.span(),
            directory: of(table.directory.as_ref(), whole),
            version: of(table.version.as_ref(), whole),
            start_timeout: of(table.start_timeout.as_ref(), whole),
            case_timeout: of(table.case_timeout.as_ref(), whole),
            grace: of(table.grace.as_ref(), whole),
            processes: of(table.processes.as_ref(), whole),
            may_decline: of(table.may_decline.as_ref(), whole),
            tolerance: of(table.tolerance.as_ref(), whole),
        }
    }

    /// Where the field stands that is not allowed.
    pub fn field(&self, invalid: &Invalid) -> &Range<usize> {
        match invalid.field {
            "start-timeout" => &self.start_timeout,
            "case-timeout" => &self.case_timeout,
            "grace" => &self.grace,
            "processes" => &self.processes,
            field if field.starts_with("tolerance") => &self.tolerance,
            _ => &self.run,
        }
    }
}
