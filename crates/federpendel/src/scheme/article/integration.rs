//! The scheme among the other methods.

use super::{Scheme as ArticleScheme, Step};
use crate::error::Result;
use crate::oscillator::State;
use crate::scheme::{DryFriction, Integration, Scheme, Setting};

/// The entry of the list of methods. Second order without friction, first order with any, as its velocity
/// lags by half a step.
pub const SCHEME: Scheme =
    Scheme { name: "article-scheme", order: 1, adaptive: false, dry: DryFriction::Sign, start };

struct OnItsWay<S> {
    steps: S,
    before: Step,
    now: Step,
}

fn start(setting: &Setting) -> Result<Box<dyn Integration>> {
    let scheme = ArticleScheme::new(&setting.oscillator, setting.release, setting.time_step)?;
    let mut steps = scheme.steps();
    let release = steps.next().unwrap_or_else(|| scheme.step(0, scheme.start()))?;
    Ok(Box::new(OnItsWay { steps, before: release, now: release }))
}

impl<S: Iterator<Item = Result<Step>>> Integration for OnItsWay<S> {
    fn step(&mut self) -> Result<()> {
        // After the step that diverged there is none, and it has been reported.
        let Some(next) = self.steps.next() else { return Ok(()) };
        self.before = std::mem::replace(&mut self.now, next?);
        Ok(())
    }

    fn time(&self) -> f64 {
        self.now.time
    }

    fn state(&self) -> State {
        State { position: self.now.position, velocity: self.now.velocity }
    }

    fn within(&self, time: f64) -> State {
        let fraction = (time - self.before.time) / (self.now.time - self.before.time);
        let between = |from: f64, to: f64| from + fraction * (to - from);
        if time >= self.now.time {
            return self.state();
        }
        State {
            position: between(self.before.position, self.now.position),
            velocity: between(self.before.velocity, self.now.velocity),
        }
    }
}
