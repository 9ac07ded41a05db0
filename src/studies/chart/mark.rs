//! Reference lines.

/// A dashed line across a panel, at a value of one axis.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// Upright, at a place on the first axis; its label stands above the panel.
    At {
        /// The place.
        x: f64,
        /// A short label; may be empty.
        label: String,
    },
    /// Level, at a place on the second axis; its label stands to the right of the panel.
    Level {
        /// The place.
        y: f64,
        /// A short label; may be empty.
        label: String,
    },
}

impl Mark {
    /// An upright line.
    pub fn at(x: f64, label: impl Into<String>) -> Self {
        Self::At { x, label: label.into() }
    }

    /// A level line.
    pub fn level(y: f64, label: impl Into<String>) -> Self {
        Self::Level { y, label: label.into() }
    }

    /// The place on the first axis, if upright.
    pub(super) fn x(&self) -> Option<f64> {
        if let Self::At { x, .. } = self { Some(*x) } else { None }
    }

    /// The place on the second axis, if level.
    pub(super) fn y(&self) -> Option<f64> {
        if let Self::Level { y, .. } = self { Some(*y) } else { None }
    }

    pub(super) fn label(&self) -> &str {
        let (Self::At { label, .. } | Self::Level { label, .. }) = self;
        label
    }
}
