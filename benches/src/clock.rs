//! A clock for noisy machines: the candidates run in turn, many times over, so that what disturbs
//! one disturbs its peers too.

use std::time::{Duration, Instant};

/// What one call took, s.
#[derive(Debug, Clone, Copy)]
pub struct Timing {
    /// The quickest round.
    pub least: f64,
    /// The median of the rounds.
    pub median: f64,
}

/// Something to be timed.
pub type Candidate<'a> = Box<dyn FnMut() + 'a>;

/// Each candidate is called until a round has taken this long.
const ROUND: Duration = Duration::from_millis(2);

/// Times the candidates in turn for about `patience` in all.
pub fn race(candidates: &mut [Candidate], patience: Duration) -> Vec<Timing> {
    let calls: Vec<u32> = candidates.iter_mut().map(calls_in_a_round).collect();
    let mut rounds = vec![Vec::new(); candidates.len()];
    let start = Instant::now();
    while rounds[0].len() < 3 || start.elapsed() < patience && rounds[0].len() < 2001 {
        for ((candidate, calls), seconds) in candidates.iter_mut().zip(&calls).zip(&mut rounds) {
            seconds.push(time(candidate, *calls));
        }
    }
    rounds.into_iter().map(summary).collect()
}

/// Times one candidate alone.
pub fn alone(candidate: Candidate, patience: Duration) -> Timing {
    race(&mut [candidate], patience)[0]
}

/// Seconds for one of `calls` calls.
fn time(candidate: &mut Candidate, calls: u32) -> f64 {
    let start = Instant::now();
    for _ in 0..calls {
        candidate();
    }
    start.elapsed().as_secs_f64() / f64::from(calls)
}

fn calls_in_a_round(candidate: &mut Candidate) -> u32 {
    let mut calls = 1;
    loop {
        let seconds = time(candidate, calls) * f64::from(calls);
        if seconds >= 0.5 * ROUND.as_secs_f64() || calls >= 1 << 20 {
            return calls;
        }
        calls *= 2;
    }
}

fn summary(mut seconds: Vec<f64>) -> Timing {
    seconds.sort_by(f64::total_cmp);
    Timing { least: seconds[0], median: seconds[seconds.len() / 2] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slower_one_takes_longer() {
        let wait = |ms| Box::new(move || std::thread::sleep(Duration::from_millis(ms))) as _;
        let timings = race(&mut [wait(1), wait(4)], Duration::from_millis(20));
        assert!(timings[0].median < timings[1].median);
        assert!(timings[0].least >= 1e-3 && timings[0].least <= timings[0].median);
    }
}
