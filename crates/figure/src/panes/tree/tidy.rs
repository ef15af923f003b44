//! A tidy layout of a tree: parents over the middle of their children, subtrees as close as they fit.
//! After Reingold and Tilford 1981.

/// A node of a tree that is to be drawn: its width and its children, which come later in the array.
#[derive(Clone, Debug, Default)]
pub(crate) struct Twig {
    /// The room it needs to the left and to the right of its middle.
    pub(crate) sides: [f32; 2],
    /// Indices into the same array, each larger than this node's own.
    pub(crate) children: Vec<usize>,
}

/// Where the nodes lie: the middle of each in x, from 0 to `width`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Tidy {
    pub(crate) x: Vec<f32>,
    pub(crate) width: f32,
}

/// The outline of a subtree: for each level, its leftmost and rightmost extent around its root.
type Outline = Vec<(f32, f32)>;

/// Lays out the tree whose root is the first of `twigs`, `gap` apart.
pub(crate) fn tidy(twigs: &[Twig], gap: f32) -> Tidy {
    let mut outlines: Vec<Outline> = vec![Outline::new(); twigs.len()];
    let mut offset = vec![0.0; twigs.len()];

    // From the leaves up: push each child's outline as far left as the earlier ones allow.
    for (index, twig) in twigs.iter().enumerate().rev() {
        let mut together = Outline::new();
        let mut places = Vec::new();
        for &child in &twig.children {
            let outline = std::mem::take(&mut outlines[child]);
            let shift = together
                .iter()
                .zip(&outline)
                .map(|(left, right)| left.1 - right.0 + gap)
                .fold(f32::NEG_INFINITY, f32::max);
            let shift = if shift.is_finite() { shift } else { 0.0 };
            places.push(shift);
            join(&mut together, &outline, shift);
        }
        // The parent over the middle of the first and the last.
        let middle = (places.first().unwrap_or(&0.0) + places.last().unwrap_or(&0.0)) / 2.0;
        for (&child, place) in twig.children.iter().zip(&places) {
            offset[child] = place - middle;
        }
        outlines[index] = std::iter::once((-twig.sides[0], twig.sides[1]))
            .chain(together.iter().map(|(left, right)| (left - middle, right - middle)))
            .collect();
    }

    let outline = outlines.first().cloned().unwrap_or_default();
    let left = outline.iter().map(|level| level.0).fold(0.0, f32::min);
    let right = outline.iter().map(|level| level.1).fold(0.0, f32::max);
    let mut x = vec![-left; twigs.len()];
    for (index, twig) in twigs.iter().enumerate() {
        for &child in &twig.children {
            x[child] = x[index] + offset[child];
        }
    }
    Tidy { x, width: right - left }
}

/// Adds an outline, moved right by `shift`, to the right of `together`.
fn join(together: &mut Outline, outline: &Outline, shift: f32) {
    for (level, &(left, right)) in outline.iter().enumerate() {
        match together.get_mut(level) {
            Some(both) => both.1 = right + shift,
            None => together.push((left + shift, right + shift)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tree(children: &[&[usize]]) -> Vec<Twig> {
        children.iter().map(|&children| Twig { sides: [1.0; 2], children: children.to_vec() }).collect()
    }

    #[test]
    fn a_parent_stands_over_the_middle_of_its_children() {
        let tidy = tidy(&tree(&[&[1, 2], &[], &[]]), 1.0);
        assert_eq!(tidy, Tidy { x: vec![2.5, 1.0, 4.0], width: 5.0 });
    }

    #[test]
    fn a_shallow_subtree_moves_over_a_deep_one_only_as_far_as_it_fits() {
        // 1 has two children; 2 is a leaf and may stand above the right one of them.
        let tidy = tidy(&tree(&[&[1, 2], &[3, 4], &[], &[], &[]]), 1.0);
        assert_eq!(tidy.x, [4.0, 2.5, 5.5, 1.0, 4.0]);
    }

    #[test]
    fn nodes_of_a_level_never_overlap() {
        let tidy = tidy(&tree(&[&[1, 2], &[3, 4], &[5, 6], &[7, 8], &[], &[], &[9, 10], &[], &[], &[], &[]]), 0.5);
        let levels: [&[usize]; 4] = [&[0], &[1, 2], &[3, 4, 5, 6], &[7, 8, 9, 10]];
        for level in levels {
            assert!(level.windows(2).all(|pair| tidy.x[pair[1]] - tidy.x[pair[0]] >= 2.5), "{level:?} {tidy:?}");
        }
    }
}
