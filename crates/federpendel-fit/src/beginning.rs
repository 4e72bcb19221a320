//! Which of the first values do not belong to the motion, as a fit of the rest shows.

use std::f64::consts::PI;

use federpendel::Mix;

use crate::Recording;
use crate::check::FEWEST;
use crate::error::FitError;
use crate::extremes::{finest_noise, look};
use crate::fit::Fits;
use crate::held::plateau;
use crate::least_squares::Minimum;
use crate::options::Options;
use crate::problem::OMEGA;
use crate::window::{Edge, Found, Window};

/// A mass that was held for longer than so many half periods does not pass for free.
const HELD: f64 = 1.5;
/// So much of half a period a hand may push after the mass has set off.
const PUSHES: f64 = 0.2;
/// A mean square of residuals below so many times the variance of the noise leaves nothing to be made better: of 200 values both
/// vary by a tenth.
const CLOSE: f64 = 1.3;
/// Squares of residuals that are so many times larger with the first values than without them are not those of one motion: of
/// free ones they are up to 1.1 times as large, of held ones 2 to thousands of times.
const WORSE: f64 = 2.0;

/// The window without first values that do not belong to the motion, as those of a hand that let go late, and the fits
/// of all mixes of `laws` to it. Where the beginning was asked for it stays.
pub fn settled<'a>(
    recording: &Recording,
    mut found: Found,
    options: &Options,
    laws: Mix,
) -> Result<(Found, Fits<'a>), FitError> {
    let mut fits = Fits::new(recording, &found, options, laws)?;
    if options.from.is_some() {
        return Ok((found, fits));
    }
    for begin in [Fits::set_off, Fits::let_go] {
        let first = begin(&fits, recording, &found.window);
        let better = first.and_then(|first| {
            far_better(recording, (&found, &mut fits), first, |shorter| {
                Fits::new(recording, shorter, options, laws).ok()
            })
        });
        (found, fits) = better.unwrap_or((found, fits));
    }
    let mut uncut = None;
    for _ in 0..3 {
        let Some(first) = fits.misfit(&found.window) else { break };
        let Window { end, ends, .. } = found.window;
        let window = Window::between(&recording.times, first, end, Edge::Misfit, ends);
        let shorter = seen(recording, window, &found);
        let Ok(again) = Fits::new(recording, &shorter, options, laws) else { break };
        uncut.get_or_insert((found, fits));
        (found, fits) = (shorter, again);
    }
    // What stays however much is cut comes of a motion that no mix describes, not of a hand.
    let stays = uncut.is_some() && fits.misfit(&found.window).is_some();
    Ok(uncut.filter(|_| stays).unwrap_or((found, fits)))
}

/// The window from index `first` on and what `fit` makes of it, if that fits far better there than the longer window does.
fn far_better<'a>(
    recording: &Recording,
    (found, fits): (&Found, &mut Fits<'a>),
    first: usize,
    fit: impl Fn(&Found) -> Option<Fits<'a>>,
) -> Option<(Found, Fits<'a>)> {
    let Window { first: before, end, ends, .. } = found.window;
    let noise = finest_noise(&recording.values[before..end]).powi(2);
    if end < first + FEWEST || fits.mean_square(0)? < CLOSE * noise {
        return None;
    }
    let window = Window::between(&recording.times, first, end, Edge::Held, ends);
    let shorter = seen(recording, window, found);
    let mut again = fit(&shorter)?;
    (fits.mean_square(first - before)? > WORSE * again.mean_square(0)?).then_some((shorter, again))
}

/// What a first look at `window` finds, or else what one at a longer window found.
fn seen(recording: &Recording, window: Window, longer: &Found) -> Found {
    let part = window.first..window.end;
    let look = look(&recording.times[part.clone()], &recording.values[part]);
    Found { window, look: look.or(longer.look.clone()) }
}

impl Fits<'_> {
    /// Where first values end that are much alike, as of a mass that is held, be it for a part of a swing only.
    fn set_off(&self, recording: &Recording, window: &Window) -> Option<usize> {
        let end = plateau(&recording.values[window.first..window.end])?.end;
        let lasts = recording.times[window.first + end] - window.from;
        (lasts < HELD * self.half()).then_some(window.first + end)
    }

    /// When a hand has let go at the latest that still pushed where the window begins.
    fn let_go(&self, recording: &Recording, window: &Window) -> Option<usize> {
        let late = window.from + PUSHES * self.half();
        (window.begins == Edge::Held).then(|| recording.times.partition_point(|&t| t < late))
    }

    /// Half a period, s.
    fn half(&self) -> f64 {
        PI / self.largest().minimum.at[OMEGA]
    }

    /// The mean of the squares of the residuals from an index on, of the largest mix.
    fn mean_square(&mut self, from: usize) -> Option<f64> {
        let Minimum { at, ending, .. } = self.largest().minimum;
        let residuals = self.problem.residuals(&at, ending)?;
        let part = &residuals[from..];
        Some(part.iter().map(|r| r * r).sum::<f64>() / part.len() as f64)
    }

    /// The index from which on the recording fits, if its first values do not belong to the motion:
    /// over the first eighth of a period, or over the first swing, the residuals are far larger
    /// than after it.
    fn misfit(&mut self, window: &Window) -> Option<usize> {
        let Minimum { at, ending, .. } = self.largest().minimum;
        let residuals = self.problem.residuals(&at, ending)?;
        let begin = self.problem.times[0];
        let half = self.half();
        let index =
            |swings: f64| self.problem.times.partition_point(|&t| t <= begin + swings * half);
        let rms = |from: usize, to: usize| {
            let part = &residuals[from..to];
            (part.iter().map(|r| r * r).sum::<f64>() / part.len().max(1) as f64).sqrt()
        };
        // How long the part is, how many times larger its residuals, and where the window begins
        // without it.
        for (part, times, without) in [(0.25, 3.0, 0.6), (1.0, 2.0, 1.0)] {
            let (end, later) = (index(part), index(part + 4.0));
            let enough = end >= 2 && later >= end + FEWEST && self.problem.len() >= 2 * later;
            if enough && rms(0, end) > times * rms(end, later) {
                return Some(window.first + index(without));
            }
        }
        None
    }
}
