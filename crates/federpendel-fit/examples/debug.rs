#[path = "../tests/synthetic/mod.rs"]
mod synthetic;
fn main() {
    let want: usize = std::env::args().nth(1).unwrap().parse().unwrap();
    let mut random = synthetic::Random(1u64.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    for i in 0..=want {
        let k = synthetic::known(&mut random, 0.0).unwrap();
        if i == want {
            let look = federpendel_fit::extremes::look(&k.recording.times, &k.recording.values).unwrap();
            println!("half {} noise {} left {} sigma {} true half {}", look.half, look.noise, look.left, k.sigma, std::f64::consts::PI / k.truth.angular_frequency);
            for w in look.extremes.windows(2) { println!("{:.4} {:.4} {:.4}", w[0].time - k.recording.times[0], w[0].value - k.truth.equilibrium, (w[1].value - w[0].value).abs()); }
        }
    }
}
