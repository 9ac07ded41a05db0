//! Every line of the talk can be kept.

use std::sync::{Arc, Mutex};

use process::{Direction, Engine, Line, Sink};

use crate::common::{case, launch};

#[derive(Default)]
struct Kept(Mutex<Vec<(String, usize, Direction, String)>>);

impl Sink for Kept {
    fn keep(&self, line: &Line<'_>) {
        self.0.lock().unwrap().push((line.engine.to_owned(), line.process, line.direction, line.text.to_owned()));
    }
}

#[test]
fn both_directions_are_kept_in_order() {
    let kept = Arc::new(Kept::default());
    let engine = Engine::start(launch("garbage"), Some(Arc::clone(&kept) as Arc<dyn Sink>)).unwrap();
    let _ = engine.answer(&case(0.9));
    drop(engine);
    let lines = kept.0.lock().unwrap();
    assert!(lines.iter().all(|(engine, process, ..)| engine == "fake" && *process == 0));
    let starts = [
        (Direction::To, "{\"cmd\":\"start\",\"versions\":[1],\"echo\":[0.1,5e-324,1.7976931348623157e+308,-0.0]}"),
        (Direction::From, "{\"claims\":false,\"echo\":[0.1,"),
        (
            Direction::To,
            "{\"cmd\":\"case\",\"seq\":1,\"model\":\"linear\",\"epsilon\":0.25,\"omega\":2.0,\"eta\":0.9,\"alpha\":null,\"normalisation\":\"threshold\",\"ground\":{\"sine\":{\"start\":\"threshold\"}},\"impacts\":4,\"until\":\"half-period\"}",
        ),
        (Direction::From, "step 1 of 100"),
    ];
    assert_eq!(lines.len(), starts.len(), "{lines:?}");
    for ((_, _, direction, text), (expected, start)) in lines.iter().zip(starts) {
        assert_eq!(*direction, expected);
        assert!(text.starts_with(start), "{text}");
    }
}
