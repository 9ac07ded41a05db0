//! A tidy CSV file: a header, and rows of fields read as text or numbers by the name of their column.

use std::{fs::File, io::Read, path::Path};

use super::{Cell, Error, Point, Series, csv_in_words};

/// The rows of a CSV file, in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    file: String,
    columns: Vec<String>,
    rows: Vec<Row>,
}

#[derive(Debug, Clone, PartialEq)]
struct Row {
    line: u64,
    fields: Vec<String>,
}

impl Table {
    /// The table in the file at `path`.
    ///
    /// # Errors
    /// When the file can't be read, or its rows are not all as long as its header.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let file = File::open(path).map_err(|error| Error::Csv { file: name.clone(), how: error.to_string() })?;
        Self::from_reader(&name, file)
    }

    /// The table in `reader`; `name` is what errors call it.
    ///
    /// # Errors
    /// When it can't be read, or its rows are not all as long as its header.
    pub fn from_reader(name: &str, reader: impl Read) -> Result<Self, Error> {
        let wrong = |error| Error::Csv { file: name.to_owned(), how: csv_in_words(&error) };
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(reader);
        let columns = reader.headers().map_err(wrong)?.iter().map(str::to_owned).collect();
        let rows = reader
            .records()
            .map(|record| {
                let record = record.map_err(wrong)?;
                let line = record.position().map_or(0, csv::Position::line);
                Ok(Row { line, fields: record.iter().map(str::to_owned).collect() })
            })
            .collect::<Result<_, Error>>()?;
        Ok(Self { file: name.to_owned(), columns, rows })
    }

    /// How many rows there are below the header.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is only a header.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The fields of a column, as they are written.
    ///
    /// # Errors
    /// When there is no such column.
    pub fn texts(&self, column: &str) -> Result<Vec<&str>, Error> {
        Ok(self.fields(column)?.map(|(_, text)| text).collect())
    }

    /// The numbers of a column: `None` where the field is empty, infinite or `NaN`.
    ///
    /// # Errors
    /// When there is no such column, or a field that is neither empty nor a number.
    pub fn numbers(&self, column: &str) -> Result<Vec<Option<f64>>, Error> {
        self.fields(column)?.map(|(line, text)| self.number(line, column, text)).collect()
    }

    /// The rows in which the field of `column` reads `text`.
    ///
    /// # Errors
    /// When there is no such column.
    pub fn filter(&self, column: &str, text: &str) -> Result<Self, Error> {
        let keep: Vec<bool> = self.fields(column)?.map(|(_, field)| field == text).collect();
        let rows = self.rows.iter().zip(keep).filter(|(_, keep)| *keep).map(|(row, _)| row.clone()).collect();
        Ok(Self { file: self.file.clone(), columns: self.columns.clone(), rows })
    }

    /// The rows by the text of `column`, in the order in which the texts first appear: one group for each panel of a chart.
    ///
    /// # Errors
    /// When there is no such column.
    pub fn groups(&self, column: &str) -> Result<Vec<(String, Self)>, Error> {
        let mut names: Vec<&str> = Vec::new();
        for (_, text) in self.fields(column)? {
            if !names.contains(&text) {
                names.push(text);
            }
        }
        names.into_iter().map(|name| Ok((name.to_owned(), self.filter(column, name)?))).collect()
    }

    /// One series for each text in the column `series`, in the order in which the texts first appear; an empty `y` is a failure.
    ///
    /// # Errors
    /// When a column is missing, a field is no number, or an `x` is empty or not finite.
    pub fn series(&self, series: &str, x: &str, y: &str) -> Result<Vec<Series>, Error> {
        let groups = self.groups(series)?;
        groups.into_iter().map(|(name, rows)| Ok(Series::new(name, rows.points(x, y)?))).collect()
    }

    /// All rows as points; an empty `y` is a failure.
    ///
    /// # Errors
    /// As [`Table::series`].
    pub fn points(&self, x: &str, y: &str) -> Result<Vec<Point>, Error> {
        Ok(self.places(x)?.into_iter().zip(self.numbers(y)?).map(|(x, y)| Point { x, y }).collect())
    }

    /// All rows as the cells of a heat map; an empty `value` is a failure.
    ///
    /// # Errors
    /// When a column is missing, a field is no number, or an `x` or `y` is empty or not finite.
    pub fn cells(&self, x: &str, y: &str, value: &str) -> Result<Vec<Cell>, Error> {
        let places = self.places(x)?.into_iter().zip(self.places(y)?);
        Ok(places.zip(self.numbers(value)?).map(|((x, y), value)| Cell { x, y, value, why: 0 }).collect())
    }

    fn places(&self, column: &str) -> Result<Vec<f64>, Error> {
        self.fields(column)?
            .map(|(line, text)| {
                self.number(line, column, text)?.ok_or_else(|| Error::NoPlace {
                    file: self.file.clone(),
                    line,
                    column: column.to_owned(),
                })
            })
            .collect()
    }

    fn number(&self, line: u64, column: &str, text: &str) -> Result<Option<f64>, Error> {
        if text.is_empty() {
            return Ok(None);
        }
        match text.parse::<f64>() {
            Ok(value) => Ok(value.is_finite().then_some(value)),
            Err(_) => Err(Error::NotANumber {
                file: self.file.clone(),
                line,
                column: column.to_owned(),
                value: text.to_owned(),
            }),
        }
    }

    /// The line and the text of each field of a column.
    fn fields(&self, column: &str) -> Result<impl Iterator<Item = (u64, &str)>, Error> {
        let index = self.columns.iter().position(|name| name == column).ok_or_else(|| Error::NoColumn {
            file: self.file.clone(),
            column: column.to_owned(),
            present: self.columns.clone(),
        })?;
        Ok(self.rows.iter().map(move |row| (row.line, row.fields.get(index).map_or("", String::as_str))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CSV: &str =
        "method,eta,a,error\nexact,0.9,1.01,1e-16\nfit,0.9,1.01,\nexact,0.8,1.02,inf\nexact,0.9,1.03,2e-16\n";

    fn table(text: &str) -> Table {
        Table::from_reader("errors.csv", text.as_bytes()).unwrap()
    }

    #[test]
    fn series_and_groups_come_in_the_order_of_the_file() {
        let table = table(CSV);
        let series = table.filter("eta", "0.9").unwrap().series("method", "a", "error").unwrap();
        assert_eq!(series.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["exact", "fit"]);
        assert_eq!(series[0].points, [Point { x: 1.01, y: Some(1e-16) }, Point { x: 1.03, y: Some(2e-16) }]);
        assert_eq!(series[1].points, [Point { x: 1.01, y: None }]);
        let groups = table.groups("eta").unwrap();
        assert_eq!(
            groups.iter().map(|(name, rows)| (name.as_str(), rows.len())).collect::<Vec<_>>(),
            [("0.9", 3), ("0.8", 1)]
        );
        assert_eq!(groups[1].1.numbers("error").unwrap(), [None], "infinite is a failure");
    }

    #[test]
    fn a_bad_number_is_named_by_line_and_column() {
        let error = table("a,error\n1.01,1e-3\n1.02,1e-3x\n").points("a", "error").unwrap_err();
        assert_eq!(error.to_string(), "errors.csv, line 3, column \"error\": \"1e-3x\" is not a number");
        let error = table("a,error\n,1e-3\n").points("a", "error").unwrap_err();
        assert_eq!(error.to_string(), "errors.csv, line 2, column \"a\": a finite number is needed to place the row");
    }

    #[test]
    fn a_missing_column_is_named_with_those_that_are_there() {
        let error = table(CSV).numbers("tau").unwrap_err();
        assert_eq!(error.to_string(), "errors.csv: no column \"tau\"; there are method, eta, a, error");
        assert!(Table::read("no/such.csv").unwrap_err().to_string().starts_with("no/such.csv "));
        assert!(Table::from_reader("short.csv", "a,b\n1\n".as_bytes()).is_err(), "a short row is an error");
    }
}
