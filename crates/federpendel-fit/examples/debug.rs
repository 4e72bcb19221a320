#[path = "../tests/synthetic/mod.rs"]
mod synthetic;
use federpendel_fit::*;
fn main() {
    let want: usize = std::env::args().nth(1).unwrap().parse().unwrap();
    let seed: u64 = std::env::args().nth(2).unwrap().parse().unwrap();
    let mut random = synthetic::Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    for i in 0..=want {
        let k = synthetic::known(&mut random, 0.0).unwrap();
        if i == want {
            let r = fit(&k.recording, &Options { ..Options::default() }).unwrap();
            let m = r.model(k.mix).unwrap();
            println!("evals {} cost/truth {} {:?}", r.evaluations, m.chi_square / k.noise[r.window.first..r.window.end].iter().map(|x| x * x).sum::<f64>(), m.stop_reason);
            println!("{:?}\nstatic {} rests {:?} fit rest {:?}", k.truth, k.static_acceleration, k.rests, m.rest);
            for p in &m.parameters { println!("{} {:?} {:?}", p.name, p.value, p.stderr); }
            let motion = synthetic::motion(&k.truth, k.static_acceleration).unwrap();
            let t0 = k.recording.times[k.release];
            let turns: Vec<f64> = motion.turning_points().take(100).map(|p| p.time + t0).collect();
            println!("verdict {}", r.verdict.mix); for (j, res) in r.residuals.iter().enumerate() {
                if res.abs() > 5.0 * k.sigma { 
                    let t = k.recording.times[r.window.first + j];
                    let near = turns.iter().map(|x| t - x).min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0);
                    println!("residual {j} {:.2} sigma; {:.3} steps from the turn", res / k.sigma, near / (k.recording.times[1] - k.recording.times[0])); }
            }
        }
    }
}
