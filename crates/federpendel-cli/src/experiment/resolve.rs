//! From given values to a complete experiment.

use federpendel::{Coulomb, Friction, Newton, NormalForce, Oscillator, State, Stokes};

use super::{Draft, Error, Experiment, Field, Given};

impl Draft {
    /// The complete experiment, with defaults filled in; `samples_that_fit` into memory at most.
    ///
    /// # Errors
    /// The first value that is missing, out of its range, or at odds with another.
    pub fn resolve(&self, samples_that_fit: usize) -> Result<Experiment, Error> {
        for field in Field::ALL {
            if let Some(given) = self.get(*field) {
                in_range(given)?;
            }
        }
        let normal_force = self.normal_force();
        let friction =
            Friction { stokes: self.stokes()?, coulomb: self.coulomb()?, newton: self.newton()? };
        let (mass, stiffness) = (self.required(Field::Mass)?, self.required(Field::Stiffness)?);
        let release = State::new(
            self.required(Field::Position)?,
            self.value(Field::Velocity).unwrap_or(0.0),
        )?;
        Ok(Experiment {
            oscillator: Oscillator::new(mass, stiffness, friction)?,
            normal_force,
            release,
            drag_coefficient: self.get(Field::DragCoefficient).map(|given| given.value),
            duration: self.value(Field::Duration),
            samples: self.samples(samples_that_fit)?,
        })
    }

    fn value(&self, field: Field) -> Option<f64> {
        self.get(field).map(|given| given.value).or(field.info().default)
    }

    fn required(&self, field: Field) -> Result<f64, Error> {
        self.value(field).ok_or(Error::Missing(field))
    }

    fn normal_force(&self) -> NormalForce {
        match self.get(Field::NormalForce) {
            Some(given) => NormalForce::Given(given.value),
            None => NormalForce::Weight(self.value(Field::Gravity).unwrap_or(0.0)),
        }
    }

    fn stokes(&self) -> Result<Option<Stokes>, Error> {
        Ok(self.value(Field::Damping).map(Stokes::new).transpose()?)
    }

    fn coulomb(&self) -> Result<Option<Coulomb>, Error> {
        let (kinetic, static_) = match (self.get(Field::Kinetic), self.get(Field::Static)) {
            (None, None) => return Ok(None),
            (None, Some(static_)) => return Err(Error::StaticWithoutKinetic(static_.clone())),
            (Some(kinetic), static_) => (kinetic, static_.unwrap_or(kinetic)),
        };
        if static_.value < kinetic.value {
            let (static_, kinetic) = (static_.clone(), kinetic.clone());
            return Err(Error::StaticBelowKinetic { static_, kinetic });
        }
        let pressing = self.get(Field::NormalForce).or(self.get(Field::Gravity));
        if let Some(given) = pressing.filter(|given| given.value == 0.0 && static_.value > 0.0) {
            return Err(Error::NoNormalForce(given.clone()));
        }
        Ok(Some(Coulomb::new(kinetic.value, static_.value, self.normal_force())?))
    }

    fn newton(&self) -> Result<Option<Newton>, Error> {
        if let Some(coefficient) = self.value(Field::NewtonCoefficient) {
            return Ok(Some(Newton::new(coefficient)?));
        }
        let drag = Field::DRAG.map(|field| self.get(field));
        let Some(given) = drag.iter().find_map(|given| *given) else { return Ok(None) };
        match drag {
            [Some(density), Some(drag_coefficient), Some(area)] => {
                let law = Newton::from_drag(density.value, drag_coefficient.value, area.value)?;
                Ok(Some(law))
            }
            _ => {
                let missing = Field::DRAG.into_iter().find(|field| self.get(*field).is_none());
                let missing = missing.unwrap_or(Field::NewtonCoefficient);
                Err(Error::Incomplete { given: given.clone(), missing })
            }
        }
    }

    fn samples(&self, fit: usize) -> Result<usize, Error> {
        let samples = self.value(Field::Samples).unwrap_or(0.0);
        match self.get(Field::Samples) {
            Some(given) if samples > fit as f64 => {
                Err(Error::TooManySamples { given: given.clone(), fit })
            }
            // In range, so whole and at least two; no larger than `fit`, so it is a `usize`.
            _ => Ok(samples as usize),
        }
    }
}

fn in_range(given: &Given) -> Result<(), Error> {
    if given.field.info().range.contains(given.value) {
        Ok(())
    } else {
        Err(Error::Range(given.clone()))
    }
}
