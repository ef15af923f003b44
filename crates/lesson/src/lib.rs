//! The lecture as data: slides, their beats, rays and questions, and the checker.
