//! The functions that JavaScript calls; `web/src/engine.ts` gives them their types.
//!
//! Lists and records go as JSON, samples as arrays of numbers. What is refused is thrown as the JSON of a [`Refusal`].

use serde::Serialize;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::asked::Asked;
use crate::words::catalogue;
use crate::{Experiment, Refusal, compare, link, motion, parameters, presets, recording, words};

fn json(value: &impl Serialize) -> String {
    // Nothing here has keys that are no texts.
    serde_json::to_string(value).unwrap_or_default()
}

fn thrown(refusal: &Refusal) -> JsValue {
    JsValue::from_str(&json(refusal))
}

fn read(experiment: &str) -> Result<Experiment, JsValue> {
    serde_json::from_str(experiment)
        .map_err(|error| thrown(&Refusal::new("experiment", error.to_string())))
}

/// The quantities of the page.
#[wasm_bindgen]
pub fn parameters(language: &str) -> String {
    json(&parameters::parameters(catalogue(language)))
}

/// The experiments to begin with.
#[wasm_bindgen]
pub fn presets(language: &str) -> String {
    json(&presets::presets(catalogue(language)))
}

/// Which laws there are.
#[wasm_bindgen]
pub fn laws(language: &str) -> String {
    json(&words::laws(catalogue(language)))
}

/// The experiment as the end of an address.
#[wasm_bindgen]
pub fn encode(experiment: &str) -> Result<String, JsValue> {
    Ok(link::encode(&read(experiment)?))
}

/// The experiment of an address.
#[wasm_bindgen]
pub fn decode(text: &str) -> Option<String> {
    link::decode(text).map(|experiment| json(&experiment))
}

/// 2√(mC), kg/s.
#[wasm_bindgen(js_name = criticalDamping)]
pub fn critical_damping(experiment: &str) -> Result<f64, JsValue> {
    Ok(read(experiment)?.critical_damping())
}

/// A sentence.
#[wasm_bindgen]
pub fn text(language: &str, id: &str, variables: &str) -> Result<String, JsValue> {
    words::text(catalogue(language), id, variables).map_err(|refusal| thrown(&refusal))
}

/// A number with so many significant digits.
#[wasm_bindgen]
pub fn number(language: &str, value: f64, digits: usize) -> String {
    catalogue(language).number(value, digits)
}

/// A quantity in a unit in which it reads well.
#[wasm_bindgen]
pub fn quantity(language: &str, value: f64, unit: &str, digits: usize) -> String {
    catalogue(language).quantity(value, unit, digits)
}

/// What is typed into a field, SI.
#[wasm_bindgen]
pub fn parse(language: &str, written: &str, parameter: &str) -> Result<f64, JsValue> {
    words::read(catalogue(language), written, parameter).map_err(|refusal| thrown(&refusal))
}

/// The methods of the error lens.
#[wasm_bindgen]
pub fn methods(language: &str) -> String {
    json(&compare::methods(catalogue(language)))
}

/// A method beside a motion.
#[wasm_bindgen]
pub struct Compared(compare::Compared);

#[wasm_bindgen]
impl Compared {
    /// Times, positions, errors.
    pub fn numbers(&self) -> Vec<f64> {
        self.0.numbers.clone()
    }

    /// What there is to say.
    pub fn sentences(&self) -> Vec<String> {
        self.0.sentences.clone()
    }
}

/// A motion.
#[wasm_bindgen]
pub struct Solution {
    inner: motion::Solution,
    language: String,
}

#[wasm_bindgen]
impl Solution {
    /// Solves an experiment.
    #[wasm_bindgen(constructor)]
    pub fn new(experiment: &str, language: &str) -> Result<Solution, JsValue> {
        let inner = motion::Solution::new(&read(experiment)?)
            .map_err(|error| thrown(&Refusal::core(catalogue(language), &error)))?;
        Ok(Solution { inner, language: language.to_owned() })
    }

    fn refuse(&self, error: &federpendel::Error) -> JsValue {
        thrown(&Refusal::core(catalogue(&self.language), error))
    }

    /// How it is known and how it ends.
    pub fn summary(&self) -> String {
        json(&self.inner.summary(catalogue(&self.language)))
    }

    /// Times, positions, velocities, accelerations.
    pub fn samples(&self, from: f64, to: f64, count: usize) -> Result<Vec<f64>, JsValue> {
        self.inner.samples(from, to, count).map_err(|error| self.refuse(&error))
    }

    /// The same for the curve x(t).
    pub fn course(&self, from: f64, to: f64, count: usize) -> Result<Vec<f64>, JsValue> {
        self.inner.course(from, to, count).map_err(|error| self.refuse(&error))
    }

    /// The same for the phase portrait.
    pub fn orbit(&self, count: usize) -> Result<Vec<f64>, JsValue> {
        self.inner.orbit(count).map_err(|error| self.refuse(&error))
    }

    /// Times and heights of the envelope.
    pub fn envelope(&self, count: usize) -> Result<Vec<f64>, JsValue> {
        self.inner.envelope(count).map_err(|error| self.refuse(&error))
    }

    /// The ledger of the record.
    pub fn energies(&self, count: usize) -> Result<Vec<f64>, JsValue> {
        self.inner.energies(count).map_err(|error| self.refuse(&error))
    }

    /// The state and the forces at one time.
    pub fn at(&self, time: f64) -> Result<Vec<f64>, JsValue> {
        self.inner.at(time).map_err(|error| self.refuse(&error))
    }

    /// Times and places of turning points.
    #[wasm_bindgen(js_name = turningPoints)]
    pub fn turning_points(&self, most: usize) -> Vec<f64> {
        self.inner.turning_points(most)
    }

    /// Times, energies, heats.
    pub fn ledger(&self, to: f64, count: usize) -> Result<Vec<f64>, JsValue> {
        self.inner.ledger(to, count).map_err(|error| self.refuse(&error))
    }

    /// What each swing costs.
    pub fn decrement(&self) -> Result<String, JsValue> {
        let found = self.inner.decrement(catalogue(&self.language));
        found.map(|found| json(&found)).map_err(|error| self.refuse(&error))
    }

    /// A method beside it.
    pub fn compare(&self, method: &str, step: f64, count: usize) -> Result<Compared, JsValue> {
        compare::compare(&self.inner, catalogue(&self.language), method, step, count)
            .map(Compared)
            .map_err(|refusal| thrown(&refusal))
    }
}

fn asked(asked: &str) -> Result<Asked, JsValue> {
    serde_json::from_str(asked).map_err(|error| thrown(&Refusal::new("file", error.to_string())))
}

/// What is assumed of what is asked, an object of what is written in each field: a sentence for some of them.
#[wasm_bindgen(js_name = checkAsked)]
pub fn check_asked(fields: &str, language: &str) -> Result<String, JsValue> {
    let wanted = asked(fields)?.read(catalogue(language));
    wanted.map(|wanted| json(&wanted.remarks)).map_err(|refusal| thrown(&refusal))
}

/// Reads a file and fits all recordings in it, as asked.
#[wasm_bindgen]
pub fn fit(
    bytes: &[u8],
    name: &str,
    fields: &str,
    language: &str,
) -> Result<Vec<Recorded>, JsValue> {
    let fits = recording::fits(bytes, name, &asked(fields)?, catalogue(language));
    let own = |inner| Recorded { inner, language: language.to_owned() };
    fits.map(|fits| fits.into_iter().map(own).collect()).map_err(|refusal| thrown(&refusal))
}

/// A recording and its fit.
#[wasm_bindgen]
pub struct Recorded {
    inner: recording::Recorded,
    language: String,
}

#[wasm_bindgen]
impl Recorded {
    /// All but the numbers.
    pub fn shown(&self) -> String {
        json(&self.inner.shown(catalogue(&self.language)))
    }

    /// Times and values; fit and residuals of the part that was fitted.
    pub fn numbers(&self) -> Vec<f64> {
        self.inner.numbers()
    }
}
