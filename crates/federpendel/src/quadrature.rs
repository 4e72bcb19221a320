//! Gauss–Legendre quadrature with the two numbers of nodes that are needed. The tables were computed with 60 digits as the
//! roots of Legendre polynomials; a test holds them to a library, whose own tables would be a tenth of the page.

/// Integrates polynomials of twice as many degrees as it has nodes exactly.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Quadrature(&'static [(f64, f64)]);

impl Quadrature {
    /// 12 nodes.
    pub const FEW: Quadrature = Quadrature(&TWELVE);
    /// 24 nodes.
    pub const MANY: Quadrature = Quadrature(&TWENTY_FOUR);

    /// Nodes between −1 and 1 with their weights.
    pub fn nodes(self) -> impl Iterator<Item = (f64, f64)> {
        self.0.iter().flat_map(|(node, weight)| [(-node, *weight), (*node, *weight)])
    }

    /// The integral of `value` from `from` to `to`.
    pub fn integrate(self, from: f64, to: f64, value: impl Fn(f64) -> f64) -> f64 {
        let half = 0.5 * (to - from);
        half * self
            .nodes()
            .map(|(node, weight)| weight * value(from + half * (1.0 + node)))
            .sum::<f64>()
    }
}

/// The positive ones of 12 nodes, and their weights.
const TWELVE: [(f64, f64); 6] = [
    (0.9815606342467192, 0.04717533638651183),
    (0.9041172563704749, 0.10693932599531843),
    (0.7699026741943047, 0.16007832854334622),
    (0.5873179542866175, 0.20316742672306592),
    (0.3678314989981802, 0.2334925365383548),
    (0.1252334085114689, 0.24914704581340277),
];

/// The positive ones of 24.
const TWENTY_FOUR: [(f64, f64); 12] = [
    (0.9951872199970213, 0.0123412297999872),
    (0.9747285559713095, 0.028531388628933663),
    (0.9382745520027328, 0.04427743881741981),
    (0.8864155270044011, 0.05929858491543678),
    (0.820001985973903, 0.0733464814110803),
    (0.7401241915785544, 0.08619016153195327),
    (0.6480936519369755, 0.09761865210411388),
    (0.5454214713888396, 0.10744427011596563),
    (0.4337935076260451, 0.1155056680537256),
    (0.3150426796961634, 0.12167047292780339),
    (0.1911188674736163, 0.1258374563468283),
    (0.06405689286260563, 0.12793819534675216),
];

#[cfg(test)]
mod tests {
    use gauss_quad::GaussLegendre;

    use super::*;

    #[test]
    fn nodes_and_weights_are_those_of_a_library() {
        for (rule, count) in [(Quadrature::FEW, 12), (Quadrature::MANY, 24)] {
            let known = GaussLegendre::new(count.try_into().unwrap());
            assert_eq!(rule.nodes().count(), count);
            for (node, weight) in rule.nodes() {
                let near =
                    known.iter().map(|known| (known.0 - node).abs() + (known.1 - weight).abs());
                assert!(near.fold(f64::INFINITY, f64::min) < 1e-15, "{node} {weight}");
            }
        }
    }
}
