package io.github.knotresolver.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.Progress;

/**
 * A result with what was measured of it: what all writers and tables start
 * from.
 *
 * @param tracks the result
 * @param filaments its filaments, measured, in the same order
 */
public record MeasuredTracks(Tracks tracks, List<MeasuredFilament> filaments) {

	public MeasuredTracks {
		filaments = List.copyOf(filaments);
	}

	/**
	 * @param tracks a result
	 * @param progress told how far it is
	 * @return it, measured
	 */
	public static MeasuredTracks of(final Tracks tracks, final Progress progress) {
		final List<MeasuredFilament> filaments = new ArrayList<>();
		for (final FilamentTrack track : tracks.filaments()) {
			final String name = tracks.movie().name()
				+ (tracks.filaments().size() > 1 ? "-" + MeasuredFilament.number(track.id()) : "");
			filaments.add(MeasuredFilament.of(tracks.movie(), track, name, progress));
		}
		return new MeasuredTracks(tracks, filaments);
	}

	/** @return the frames of all filaments: filament by filament, each in order */
	public List<MeasuredFrame> frames() {
		return filaments.stream().flatMap(f -> f.frames().stream()).toList();
	}

	/** @return whether there is more than one filament */
	public boolean isSeveral() {
		return filaments.size() > 1;
	}

	/** @return units of length and time */
	public Calibration calibration() {
		return tracks.movie().calibration();
	}

	/**
	 * @return the dominant frequency of the tip angle of the only filament; empty if it
	 *         has none, or there are several, each with its own
	 */
	public Optional<DominantFrequency> dominantFrequency() {
		return filaments.size() == 1 ? filaments.get(0).dominantFrequency() : Optional.empty();
	}
}
