//! A method that is asked another question than it is held against.

use chattercheck::{
    cases::shaking::Question,
    gate::responses::{Responder, Whole},
    responders,
};
use contract::Model;

/// The method of the gate with this name.
pub fn method(name: &str) -> responders::Stepped {
    responders::all().into_iter().find(|method| method.name == name).unwrap()
}

/// A method that makes another question of the one that it is asked.
pub struct Mistaken {
    inner: responders::Stepped,
    ask: Box<dyn Fn(&Question) -> Question + Sync>,
}

impl Mistaken {
    /// The method with this name, asked what `ask` makes of each question.
    pub fn new(name: &str, ask: impl Fn(&Question) -> Question + Sync + 'static) -> Self {
        Self { inner: method(name), ask: Box::new(ask) }
    }
}

impl Responder for Mistaken {
    fn name(&self) -> &str {
        "mistaken"
    }

    fn model(&self) -> Model {
        self.inner.model()
    }

    fn accuracy(&self) -> f64 {
        self.inner.accuracy()
    }

    fn is_asked(&self, question: &Question) -> bool {
        self.inner.is_asked(question)
    }

    fn respond(&self, question: &Question, rows: usize) -> Option<Whole> {
        self.inner.respond(&(self.ask)(question), rows)
    }
}
