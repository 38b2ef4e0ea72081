/**
 * How far a result can be trusted, where there is no truth: movies are
 * simulated that resemble the user's own in length, motion and picture, resolved
 * with the user's parameters, and scored. The picture resembles because it is
 * made of the user's: the movie with its filament taken out, and a simulated
 * filament drawn in with the line's own profile and brightness. The motion
 * resembles because motor density, time scale and start are searched for.
 */
package io.github.knotresolver.evaluate.like;
