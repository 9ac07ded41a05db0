//! The charts, each drawn from one of the files.

use crate::studies::chart::{
    Axis, Cell, Chart, Draw, Error, HeatMap, HeatPanel, LineChart, Mark, Panel, Series, Table,
};

/// All of them.
pub const CHARTS: [Chart; 12] = [
    Chart { name: "errors.svg", table: "errors.csv", draw: errors },
    Chart { name: "errors_against_a.svg", table: "errors.csv", draw: errors_against_a },
    Chart { name: "errors_near_critical.svg", table: "errors.csv", draw: errors_near_critical },
    Chart { name: "coefficients.svg", table: "coefficients.csv", draw: coefficients },
    Chart { name: "ratios.svg", table: "coefficients.csv", draw: ratios },
    Chart { name: "critical_estimates.svg", table: "coefficients.csv", draw: critical_estimates },
    Chart { name: "first_error.svg", table: "first_error.csv", draw: first_error },
    Chart { name: "exponents.svg", table: "exponents.csv", draw: exponents },
    Chart { name: "local_exponents.svg", table: "local_exponents.csv", draw: local_exponents },
    Chart { name: "scaled_tail.svg", table: "coefficients.csv", draw: scaled_tail },
    Chart { name: "fits.svg", table: "fits.csv", draw: fits },
    Chart { name: "truncation.svg", table: "truncation.csv", draw: truncation },
];

const SHARE: &str = "(a − 1)/(a_{cr} − 1)";
const TO_GO: &str = "(a_{cr} − a)/(a_{cr} − 1)";
/// Where charts of relative errors end.
const FLOOR: f64 = 1e-16;
const ERROR: &str = "relative error of τ_{ch}";

/// The series of a table whose names pass.
fn only(table: &Table, column: &str, x: &str, y: &str, keep: impl Fn(&str) -> bool) -> Result<Vec<Series>, Error> {
    let series = table.series(column, x, y)?.into_iter().filter(|series| keep(&series.name));
    Ok(series.map(|series| series.with_least(FLOOR).with_draw(Draw::Line)).collect())
}

/// A panel for each restitution.
fn panels(table: &Table, of: impl Fn(&Table) -> Result<Vec<Series>, Error>) -> Result<Vec<Panel>, Error> {
    let groups = table.groups("eta")?.into_iter();
    groups.map(|(eta, rows)| Ok(Panel::new(format!("η = {eta}"), of(&rows)?))).collect()
}

/// The frequency of a table that has only one.
fn omega(table: &Table) -> Result<String, Error> {
    Ok(table.texts("omega")?.first().copied().unwrap_or("?").trim_end_matches(".0").to_owned())
}

fn is_of_the_series(method: &str) -> bool {
    method.starts_with("paper") || method.starts_with("order") || method == "resummed"
}

fn errors(table: &Table) -> Result<String, Error> {
    LineChart {
        title: format!("The series up to the critical amplitude, ω = {}", omega(table)?),
        caption:
            "Each order gains digits near the threshold and loses them all towards a_{cr}, where the series has a \
                  branch point; resummed with what is known of the branch point it keeps most of them until close to \
                  a_{cr}."
                .into(),
        x: Axis::linear(SHARE).with_range(0.0, 1.0),
        y: Axis::log(ERROR).with_range(FLOOR, 1.0),
        columns: 2,
        missing: "no value below T/2".into(),
        panels: panels(table, |rows| only(rows, "method", "share", "error", is_of_the_series))?,
    }
    .svg()
}

/// The restitution of the paper's Fig. 5, or the one that comes first.
fn of_fig_5(table: &Table) -> Result<(String, Table), Error> {
    let mut groups = table.groups("eta")?;
    let wanted = groups.iter().position(|(eta, _)| eta == "0.92").unwrap_or(0);
    Ok(if groups.is_empty() { (String::new(), table.filter("eta", "")?) } else { groups.swap_remove(wanted) })
}

fn errors_against_a(table: &Table) -> Result<String, Error> {
    let (eta, rows) = of_fig_5(table)?;
    let series = only(&rows, "method", "a", "error", is_of_the_series)?;
    let critical = rows.numbers("a")?.into_iter().flatten().fold(1.0, f64::max);
    LineChart {
        title: format!("Error against a, η = {eta}, ω = {}", omega(table)?),
        caption:
            "Near the threshold the error of the paper’s truncation (Eq. 65) falls as a − 1 and that of order K as \
                  its K-th power; at a_{cr} itself each doubling of the order takes off about a third."
                .into(),
        x: Axis::linear("a"),
        y: Axis::log(ERROR).with_range(FLOOR, 1.0),
        columns: 1,
        missing: "no value below T/2".into(),
        panels: vec![Panel::new("", series).with_marks(vec![Mark::at(critical, "a_{cr}")])],
    }
    .svg()
}

fn errors_near_critical(table: &Table) -> Result<String, Error> {
    let keep = |method: &str| ["resummed", "order 32", "reverted series", "H cut off", "H by Padé"].contains(&method);
    LineChart {
        title: format!("Ways to sum up to {} terms near a_{{cr}} (ω = {})", asymptotic::RESUMMED_TERMS, omega(table)?),
        caption: "The critical amplitude is to the left: the sum that knows the powers behind the branch point \
                  (resummed) holds closest to it, until it cannot tell a from a_{cr} and gives no value; H is \
                  (1 − (τ_{ch}/(T/2))²)^{1/β}, order 32 is the plain sum of 32 terms."
            .into(),
        x: Axis::log(TO_GO).with_range(1e-7, 1.0),
        y: Axis::log(ERROR).with_range(FLOOR, 1.0),
        columns: 2,
        missing: "no value below T/2".into(),
        panels: panels(table, |rows| only(rows, "method", "to_go", "error", keep))?,
    }
    .svg()
}

/// One series for each restitution.
fn by_eta(table: &Table, x: &str, y: &str) -> Result<Vec<Series>, Error> {
    let groups = table.groups("eta")?.into_iter();
    groups.map(|(eta, rows)| Ok(Series::new(format!("η = {eta}"), present(&rows, x, y)?))).collect()
}

/// The points that have both numbers. (The first coefficient has no ratio, and fewer than 16 are not resummed: no failures.)
fn present(table: &Table, x: &str, y: &str) -> Result<Vec<crate::studies::chart::Point>, Error> {
    let (x, y) = (table.numbers(x)?, table.numbers(y)?);
    Ok(x.into_iter().zip(y).filter_map(|(x, y)| Some(crate::studies::chart::Point { x: x?, y: Some(y?) })).collect())
}

fn coefficients(table: &Table) -> Result<String, Error> {
    LineChart {
        title: format!("Coefficients of ω τ_{{ch}}/ε^{{1/2}}, ω = {}", omega(table)?),
        caption: "All coefficients are positive, so the singularity that ends the convergence lies on the real axis \
                  (Pringsheim): it is a_{cr}."
            .into(),
        x: Axis::linear("k"),
        y: Axis::log("c_{k}"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", by_eta(table, "k", "coefficient")?)],
    }
    .svg()
}

fn ratios(table: &Table) -> Result<String, Error> {
    LineChart {
        title: format!("Ratios of the coefficients (Domb and Sykes), ω = {}", omega(table)?),
        caption: "Against 1/k the ratios, here over 1/(a_{cr} − 1), tend to 1 with the slope −(1 + β): their limit is \
                  1/(a_{cr} − 1), and the radius of convergence a_{cr} − 1."
            .into(),
        x: Axis::linear("1/k").with_range(0.0, 0.25),
        y: Axis::linear("(a_{cr} − 1) c_{k}/c_{k−1}").with_range(0.5, 1.02),
        columns: 1,
        missing: String::new(),
        panels: vec![
            Panel::new("", by_eta(table, "inverse_k", "ratio_over_limit")?).with_marks(vec![Mark::level(1.0, "limit")]),
        ],
    }
    .svg()
}

fn critical_estimates(table: &Table) -> Result<String, Error> {
    let of_one = |rows: &Table| {
        Ok(vec![
            Series::new("last ratio, with the exponent", present(rows, "k", "biased_error")?).with_draw(Draw::Line),
            Series::new("resummed", present(rows, "k", "resummed_error")?).with_draw(Draw::Line),
        ])
    };
    LineChart {
        title: format!("a_{{cr}} − 1 from the coefficients alone, ω = {}", omega(table)?),
        caption:
            "With the exponent known, the last ratio of k coefficients gives a_{cr} − 1 to between 10⁻² and 10⁻⁴, \
                  the fitted tail of the same coefficients to ten or a hundred times better."
                .into(),
        x: Axis::linear("k"),
        y: Axis::log("relative error of a_{cr} − 1").with_range(1e-8, 1.0),
        columns: 2,
        missing: String::new(),
        panels: panels(table, of_one)?,
    }
    .svg()
}

fn first_error(table: &Table) -> Result<String, Error> {
    let groups = table.groups("order")?.into_iter();
    let panels = groups.map(|(order, rows)| {
        let title = if order.starts_with("paper") { order } else { format!("order {order}") };
        let cells = rows.cells("omega", "eta", "a")?.into_iter();
        let above_one = cells.map(|cell| Cell { value: cell.value.map(|a| a - 1.0), ..cell });
        Ok(HeatPanel::new(title, above_one.collect()))
    });
    HeatMap {
        title: "Where each order first errs by 1 %".into(),
        caption:
            "The amplitude up to which an order can be used to 1 % depends on η far more than on ω, and ends before \
                  a_{cr} for every order; the edge in the first panel is where the error of Eq. 65 just reaches 1 % \
                  before it changes its sign."
                .into(),
        x: Axis::log("ω"),
        y: Axis::linear("η"),
        colour: Axis::log("a − 1 where the error reaches 1 %"),
        columns: 3,
        missing: vec!["below 1 % up to a_{cr}".into()],
        panels: panels.collect::<Result<_, _>>()?,
    }
    .svg()
}

fn exponents(table: &Table) -> Result<String, Error> {
    let series = vec![
        Series::new("formula", present(table, "eta", "formula")?),
        Series::new("from the coefficients", present(table, "eta", "coefficients")?).with_draw(Draw::Markers),
        Series::new("from proven chattering times", present(table, "eta", "stepping")?).with_draw(Draw::Markers),
    ];
    LineChart {
        title: format!("The exponent β of the approach to a_{{cr}} (ω = {})", omega(table)?),
        caption:
            "1 − τ_{ch}/(T/2) falls as (a_{cr} − a)^{β}: proven chattering times give the β of the formula to five \
                  digits, the coefficients of the series to three."
                .into(),
        x: Axis::linear("η"),
        y: Axis::linear("β").with_range(0.596, 0.616),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", series)],
    }
    .svg()
}

fn local_exponents(table: &Table) -> Result<String, Error> {
    let series = by_eta(table, "to_go", "off")?;
    LineChart {
        title: format!("The local exponent towards a_{{cr}} (ω = {})", omega(table)?),
        caption: "The slope of ln(1 − τ_{ch}/(T/2)) against ln(a_{cr} − a) comes near to β only as (a_{cr} − a)^{β} \
                  becomes small: a fit from afar finds another exponent."
            .into(),
        x: Axis::log(TO_GO),
        y: Axis::log("|local exponent − β|"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", series.into_iter().map(|series| series.with_draw(Draw::Line)).collect())],
    }
    .svg()
}

fn scaled_tail(table: &Table) -> Result<String, Error> {
    let series = by_eta(table, "k", "scaled_tail")?;
    LineChart {
        title: format!("The factor that is periodic in the logarithm, ω = {}", omega(table)?),
        caption: "Coefficients of H = (1 − (τ_{ch}/(T/2))²)^{1/β} with their power of k taken out: at small η they swing \
                  in ln k, with the period ln μ (1.35 at η = 0.5), because the approach to a_{cr} repeats itself in ever \
                  smaller copies; at larger η only slow corrections show."
            .into(),
        x: Axis::log("k"),
        y: Axis::linear("h_{k} (a_{cr} − 1)^{k} k^{2+β}, over the last"),
        columns: 1,
        missing: String::new(),
        panels: vec![Panel::new("", series.into_iter().map(|series| series.with_draw(Draw::Line)).collect())],
    }
    .svg()
}

fn fits(table: &Table) -> Result<String, Error> {
    let groups = table.groups("fit")?.into_iter();
    let panels = groups.map(|(fit, rows)| Ok(HeatPanel::new(fit, rows.cells("omega", "eta", "error")?)));
    HeatMap {
        title: "Fits of the critical amplitude".into(),
        caption:
            "With as many coefficients as Eqs 76 and 77 (which are meant for η above 0.75), fits in the powers that \
                  the motion has, (1 − η)^{3/7} and 1/ω², are some thousand and some hundred times nearer to a_{cr}."
                .into(),
        x: Axis::log("ω"),
        y: Axis::linear("η"),
        colour: Axis::log("error of a_{cr}").with_range(1e-8, 1e-1),
        columns: 2,
        missing: Vec::new(),
        panels: panels.collect::<Result<_, _>>()?,
    }
    .svg()
}

fn truncation(table: &Table) -> Result<String, Error> {
    let of_one = |rows: &Table| only(rows, "truncation", "share", "error", |_| true);
    LineChart {
        title: format!("The truncation of Eq. 65, ω = {}", omega(table)?),
        caption: "Eq. 65 keeps the ε^{3/2} of the odd flights and drops that of the even ones: near the threshold its \
                  error is of a lower order than that of two consistent terms; where its curve dips below, the two \
                  mistakes cancel."
            .into(),
        x: Axis::log(SHARE),
        y: Axis::log(ERROR).with_range(1e-8, 1.0),
        columns: 2,
        missing: String::new(),
        panels: panels(table, of_one)?,
    }
    .svg()
}
