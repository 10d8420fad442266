"""The models: how people get a problem wrong, each as a change of the problem.

A `Model` has the name under which mistakes are counted in a class and a function that yields its `Variation`s for a
system: every particle whose carried velocity may be missing, every spring, every pair of angles. A variation changes
the system (`mechanics`), or states what an answer's letters would have to mean (`rule`), or the special case to which
it is confined (`values`). Its `clause` continues "these are the equations ...", and `place` continues "look at ...".
To teach the program another mistake, add an entry to MODELS, in the place of its likelihood: the first that explains
an answer is named, so that small and common mistakes come before large and rare ones. Nothing else has to know of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from lagrange.answers.models import composed, forces, kinematics, kinetic, lagrangians, lengths, links, variable_masses
from lagrange.answers.models.mechanics import Mechanics, Variation
from lagrange.core.records import record


@record
class Model:
    """One kind of mistake.

    name     under which it is counted: "carried velocity left out"
    changes  what it changes in a system, the likeliest first
    """

    name: str
    changes: Callable[[Mechanics], Iterator[Variation]]


MEASURED_FROM_ELSEWHERE = "coordinate measured from elsewhere"

MODELS = (
    Model("gravity reversed", forces.gravity_reversed),
    Model("friction the other way", forces.friction_reversed),
    Model("force reversed", forces.force_reversed),
    Model(MEASURED_FROM_ELSEWHERE, kinematics.measured_from_elsewhere),
    Model("momentum of exchanged mass", variable_masses.exchanged_momentum),
    Model("varying mass taken as constant", variable_masses.mass_as_at_the_start),
    Model("constraint put into T", composed.constraint_in_energy),
    Model("quasi-velocities taken for velocities", kinematics.products_left_out),
    Model("moving frame or support taken as fixed", kinetic.frame_at_rest),
    Model("rotational energy left out", kinetic.rotation_left_out),
    Model("carried velocity left out", kinetic.velocity_left_out),
    Model("product of velocities in T left out", kinetic.product_left_out),
    Model("part of a velocity left out", composed.part_left_out),
    Model("product of parts of a velocity left out", composed.product_of_parts_left_out),
    Model("moment of inertia of another body", kinetic.other_inertia),
    Model("gravity left out", forces.gravity_left_out),
    Model("friction left out", forces.friction_left_out),
    Model("normal force of another situation", forces.other_normal_force),
    Model("T + V for T - V", forces.potential_reversed),
    Model("spring with its length for its extension", forces.spring_by_length),
    Model("carried weight left out", forces.carried_weight_left_out),
    Model("force left out", forces.force_left_out),
    Model("one weight reversed", forces.one_weight_reversed),
    Model("term of the Lagrangian", lagrangians.term_changed),
    Model("part of Lagrange's derivatives left out", lagrangians.part_of_derivative_left_out),
    Model("dT/dq left out", kinetic.gradient_left_out),
    Model("d/dt of a product half done", kinetic.product_half_done),
    Model("Coriolis terms", kinetic.mixed_terms),
    Model("centrifugal terms", kinetic.squared_terms),
    Model("dT/dq with the wrong sign", kinetic.gradient_reversed),
    Model("dT/dq of one product left out", composed.gradient_of_one_product_left_out),
    Model("constraint differentiated as if its direction were constant", composed.constraint_of_constant_direction),
    Model("angle measured from elsewhere in V", forces.angle_from_elsewhere),
    Model("sine and cosine exchanged in a force", forces.components_exchanged),
    Model("support taken as fixed in a force", forces.support_at_rest),
    Model("direction of a force that turns", forces.direction_kept),
    Model("coupling by springs left out", forces.coupling_left_out),
    Model("force on what is carried", forces.on_what_is_carried),
    Model("moving surface taken as fixed", kinematics.surface_at_rest),
    Model("energy of a spring or potential without its half", forces.energy_doubled),
    Model("square in a constraint differentiated without its 2", composed.square_differentiated_without_its_two),
    Model("one half left out", kinetic.half_left_out),
    Model("force at the end for the middle", forces.at_the_end),
    Model("force with another factor", forces.force_doubled),
    Model("mass left out", kinetic.mass_left_out),
    Model("kinetic energy of one part left out", kinetic.translation_left_out),
    Model("one part alone accelerated", kinetic.one_alone),
    Model("sine and cosine exchanged in a position", kinetic.sine_for_cosine),
    Model("sign of a coordinate in a position", kinetic.coordinate_reversed),
    Model("sum for difference of angles", kinetic.sum_of_angles),
    Model("coordinate taken as constant", kinetic.constant_coordinate),
    Model("relative for absolute", kinematics.relative_for_absolute),
    Model("relative velocity for absolute", kinematics.relative_velocities),
    Model("complementary angle", kinematics.complement),
    Model("angle measured from elsewhere in all forces", forces.gravity_turned),
    Model("parameters exchanged", kinematics.exchanged),
    Model("parameter left out", kinematics.left_out),
    Model("parameter twice or half as large", kinematics.doubled),
    Model("sum for difference of lengths", kinematics.sum_of_lengths),
    Model("one parameter for another", kinematics.one_for_another),
    Model("force in the wrong equation", forces.in_the_wrong_equation),
    Model("force on one end only", forces.on_one_end),
    Model("absolute for relative motion in a spring or damper", forces.against_the_ground),
    Model("factor of a constraint", kinematics.other_transmission),
    Model("angular velocity of what rolls or is carried", kinematics.other_angular_velocity),
    Model("angular velocity of what drives", composed.turning_relative_to_carrier),
    Model("rolling by the absolute velocity", composed.rolling_of_absolute_velocity),
    Model("moment of inertia with another factor", kinetic.odd_inertia),
    Model("mass of another part", kinetic.mass_of_another),
    Model("small angles in the kinetic energy", kinetic.angles_small_in_energy),
    Model("radius for the distance from an axis", kinetic.radius_for_distance),
    Model("length left out of a position", kinetic.length_left_out),
    Model("one of two lengths for their sum", lengths.one_of_two_lengths),
    Model("spring or damper fastened elsewhere", links.fastened_elsewhere),
    Model("lever arm of a spring or damper", links.with_another_arm),
    Model("absolute for relative extension", links.of_another_difference),
    Model("parameter taken as infinite", lagrangians.parameter_infinite),
    Model("centre taken to lie on the line that carries it", composed.offset_left_out),
    Model("length doubled in a position", kinetic.length_doubled),
    Model("another rate of what a constraint moves", kinematics.moved_at_another_rate),
    Model("another rate of what is carried along", composed.several_moved_at_another_rate),
    Model("product of velocities in T with another factor", kinetic.product_scaled),
    Model("velocity terms left out", kinetic.velocity_terms_left_out),
    Model("length taken as given", kinematics.length_for_coordinate),
    Model("factor 2", kinetic.factor_two),
    Model("parameter multiplied by another", kinematics.multiplied),
)
"""In the order of their likelihood. Several may make the same equations; then the first is named."""

_NAMES = [m.name for m in MODELS]
AS_BY_A_CONVENTION = frozenset(_NAMES[: _NAMES.index(MEASURED_FROM_ELSEWHERE) + 1])
"""The models that may come from another way of measuring a coordinate."""
