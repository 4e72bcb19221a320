//! A score, with the fields of `schemas/score.schema.json`.

use serde::Serialize;

use super::document::Schema;
use crate::score::{AfterRest, Errors, Score};

#[derive(Serialize)]
pub(super) struct ScoreDocument<'a> {
    schema: Schema,
    problem: ProblemFields<'a>,
    amplitude: f64,
    scale: Scale,
    error_bound: f64,
    samples: usize,
    position: ErrorFields,
    velocity: Option<ErrorFields>,
    last: Last,
    stored: Option<StoredFields>,
    rest: Option<RestFields>,
}

#[derive(Serialize)]
struct ProblemFields<'a> {
    name: &'a str,
    mix: &'a str,
    corner: &'a str,
    description: &'a str,
}

#[derive(Serialize)]
struct Scale {
    position: f64,
    velocity: f64,
}

#[derive(Serialize)]
struct ErrorFields {
    max_error: f64,
    time_of_max_error: f64,
    rms_error: f64,
}

impl From<Errors> for ErrorFields {
    fn from(errors: Errors) -> Self {
        ErrorFields {
            max_error: errors.largest,
            time_of_max_error: errors.time_of_largest,
            rms_error: errors.root_mean_square,
        }
    }
}

#[derive(Serialize)]
struct Last {
    time: f64,
    error: f64,
}

#[derive(Serialize)]
struct StoredFields {
    samples: usize,
    max_position_error: f64,
    max_velocity_error: Option<f64>,
}

#[derive(Serialize)]
struct RestFields {
    time: f64,
    position: f64,
    watched_from: f64,
    samples: usize,
    sticks: Option<bool>,
    creep: Option<f64>,
    range: Option<f64>,
}

impl From<AfterRest> for RestFields {
    fn from(rest: AfterRest) -> Self {
        RestFields {
            time: rest.time,
            position: rest.position + 0.0,
            watched_from: rest.watched_from,
            samples: rest.samples,
            sticks: rest.found.map(|found| found.sticks),
            creep: rest.found.map(|found| found.creep),
            range: rest.found.map(|found| found.range),
        }
    }
}

impl<'a> ScoreDocument<'a> {
    pub(super) fn new(score: &'a Score<'a>) -> Self {
        let problem = &score.problem;
        let (time, error) = score.last;
        ScoreDocument {
            schema: Schema { name: "federpendel-score", version: 1 },
            problem: ProblemFields {
                name: problem.name,
                mix: problem.mix,
                corner: problem.corner,
                description: problem.description,
            },
            amplitude: score.amplitude,
            scale: Scale { position: score.length, velocity: score.speed },
            error_bound: score.bound,
            samples: score.samples,
            position: score.position.into(),
            velocity: score.velocity.map(ErrorFields::from),
            last: Last { time, error: error + 0.0 },
            stored: score.stored.map(|stored| StoredFields {
                samples: stored.samples,
                max_position_error: stored.position,
                max_velocity_error: stored.velocity,
            }),
            rest: score.rest.map(RestFields::from),
        }
    }
}
