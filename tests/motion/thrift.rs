//! No more is computed than is needed: impacts of the tail, digits of the enclosure.

use chattercheck::{
    measure::zeno,
    plan::{Plan, Question, Way, evidence},
};
use closed_form::ClosedForm;
use contract::{Case, Ending, History, Model, Oracle};
use enclosure::Enclosure;

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// Of the slender block: the impacts that an answer took, against the fewest from which closing the sum is right to the tolerance. That number is known only to
/// who knows the truth; what does not know it has to see the error of its sum fall below the tolerance, and looks at every fourth impact.
#[test]
fn no_more_impacts_than_the_tail_needs() {
    let mut excess = Vec::new();
    for question in evidence::questions(7, 400).unwrap() {
        let case = Case::from_epsilon(question.case.epsilon(), question.case.omega(), question.case.eta()).unwrap();
        let case = case.with_max_impacts(600).unwrap();
        let history = ClosedForm.history(&case).unwrap();
        if history.ending != Ending::AtRest {
            continue;
        }
        let answer = Plan::new(Question::new(case, question.tolerance)).answer();
        let attempt = answer.attempts.last().unwrap();
        if attempt.method != Way::Linear {
            continue;
        }
        let truth = zeno::close(&history, case.eta()).unwrap().value;
        let closed = |count: usize| {
            let impacts = history.impacts[..count].to_vec();
            zeno::close(&History { impacts, ..history.clone() }, case.eta())
        };
        let right =
            |count: &usize| closed(*count).is_some_and(|sum| (sum.value / truth - 1.0).abs() <= question.tolerance);
        let fewest = (1..600).find(right).unwrap();
        excess.push(attempt.impacts as f64 - fewest as f64);
        assert!(attempt.impacts <= 2 * fewest + 24, "{case:?}: {} impacts in place of {fewest}", attempt.impacts);
    }
    println!("{} answers, {} impacts more than the fewest in the median", excess.len(), median(excess.clone()));
    assert!(excess.len() > 150 && median(excess.clone()) <= 16.0, "{} answers, {}", excess.len(), median(excess));
}

/// With how many bits the enclosure answered: 53 are those of a double, 100 those of a sum of two. What is asked for settles it, near `a_cr` too: no case of these
/// climbs further than the first format that holds its digits.
#[test]
fn no_more_digits_than_the_enclosure_needs() {
    for model in [Model::Linear, Model::Nonlinear] {
        for (digits, most_bits) in [(6, 53), (12, 100), (17, 100), (30, 128)] {
            let mut in_doubles = 0;
            let mut asked = 0;
            for question in evidence::questions(3, 60).unwrap() {
                let case = question.case.with_max_impacts(20).unwrap();
                let enclosed = Enclosure::new(model).with_digits(digits).unwrap().enclose(&case).unwrap();
                assert!(enclosed.bits <= most_bits, "{case:?}: {} bits for {digits} digits", enclosed.bits);
                in_doubles += usize::from(enclosed.bits == 53);
                asked += 1;
            }
            println!("{model:?}, {digits} digits: {in_doubles} of {asked} in doubles");
        }
    }
}
