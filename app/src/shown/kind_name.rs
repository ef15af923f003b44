//! What the kinds of structures are called.

/// What a kind of structure is called on a button.
pub(crate) fn kind_name(kind: &str) -> &str {
    match kind {
        "list" => "Brute force",
        "slab" => "Box",
        "grid" => "Grid",
        "nested-grid" => "Nested grids",
        "hashed-grid" => "Hashed grid",
        "kd" => "kd-tree",
        "octree" => "Octree",
        "bsp" => "BSP tree",
        "bvh" => "BVH",
        "fast-grid" => "Fast grid",
        "fast-kd" => "Fast kd-tree",
        "fast-bvh2" => "Fast BVH2",
        "fast-bvh8" => "Fast BVH8",
        other => other,
    }
}
