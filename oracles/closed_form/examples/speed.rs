use contract::{Case, Oracle};
fn main() {
    let mut x: u64 = 12345;
    let mut r = || {
        x = x.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (x >> 11) as f64 / (1u64 << 53) as f64
    };
    let cases: Vec<Case> = (0..20000)
        .map(|_| Case::from_amplitude(1.005 + 0.03 * r(), 0.5 + 7.5 * r(), 0.8 + 0.15 * r()).unwrap())
        .collect();
    for _ in 0..3 {
        let t = std::time::Instant::now();
        let mut n = 0usize;
        let mut s = 0.0;
        for c in &cases {
            let h = closed_form::ClosedForm.history(c).unwrap();
            n += h.impacts.len();
            s += h.impacts.last().map_or(0.0, |i| i.time);
        }
        let e = t.elapsed().as_secs_f64();
        println!("{n} impacts {:.3e}/s {:.1} ns  {s}", n as f64 / e, e / n as f64 * 1e9);
    }
}
