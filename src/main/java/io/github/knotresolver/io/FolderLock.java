package io.github.knotresolver.io;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.BitSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadLocalRandom;

import io.github.knotresolver.model.UserException;

/**
 * A lock that one run holds while it writes to a place: a small hidden file,
 * locked by the operating system, which frees it when the process ends, however
 * it ends. Guarantees that at most one run holds the lock of a file, in this
 * process and in others.
 */
final class FolderLock implements Closeable {

	/** Locks of this process: to open a locked file again would free it on POSIX systems. */
	private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();
	/** The file's size tells one file from another that took its name meanwhile. */
	private static final long LARGEST = 1 << 20;

	private final Path file;
	private final FileChannel channel;

	private FolderLock(final Path file, final FileChannel channel) {
		this.file = file;
		this.channel = channel;
	}

	/**
	 * @param file the lock's file; made if absent
	 * @return the lock; empty if another run holds it
	 * @throws UserException if a file of somebody else has that name; it is left alone
	 * @throws IOException if the file cannot be made
	 */
	static Optional<FolderLock> acquire(final Path file) throws IOException {
		if (!HELD.add(file))
			return Optional.empty();
		boolean locked = false;
		try {
			final Optional<FolderLock> lock = lock(file);
			locked = lock.isPresent();
			return lock;
		} finally {
			if (!locked)
				HELD.remove(file);
		}
	}

	private static Optional<FolderLock> lock(final Path file) throws IOException {
		while (true) {
			if (Files.isSymbolicLink(file))
				throw foreign(file);
			final FileChannel channel = open(file);
			boolean kept = false;
			try {
				if (!tryLock(channel))
					return Optional.empty();
				if (!isBlank(channel))
					throw foreign(file);
				kept = isStill(file, channel);
				if (kept)
					return Optional.of(new FolderLock(file, channel));
			} finally {
				if (!kept)
					channel.close();
			}
		}
	}

	/** Some folders of the system say that they can be written to, and take no file. */
	private static FileChannel open(final Path file) throws IOException {
		try {
			return FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ,
				StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
		} catch (final NoSuchFileException | AccessDeniedException e) {
			throw new UserException(
				"The folder " + file.getParent() + " takes no new file; choose another output.", e);
		}
	}

	/** File systems without locks exist; there, the last step of a run refuses. */
	private static boolean tryLock(final FileChannel channel) {
		try {
			return channel.tryLock() != null;
		} catch (final OverlappingFileLockException e) {
			return false;
		} catch (final IOException e) {
			return true;
		}
	}

	/** A lock's file has a size, and nothing in it but zeros. */
	private static boolean isBlank(final FileChannel channel) throws IOException {
		if (channel.size() >= LARGEST)
			return false;
		final ByteBuffer content = ByteBuffer.allocate((int) channel.size());
		while (content.hasRemaining() && channel.read(content, content.position()) > 0) {
			// All of it.
		}
		return BitSet.valueOf(content.array()).isEmpty();
	}

	private static UserException foreign(final Path file) {
		return new UserException("The file " + file
			+ " stands where this program locks its output, and is not its own; move it away, or choose another output.");
	}

	/** Whoever held the lock before may have deleted the file after it was opened here. */
	private static boolean isStill(final Path file, final FileChannel channel) throws IOException {
		final long size = ThreadLocalRandom.current().nextLong(1, LARGEST);
		channel.truncate(0);
		channel.write(ByteBuffer.wrap(new byte[1]), size - 1);
		return Files.exists(file) && Files.size(file) == size;
	}

	/** Frees the lock and removes its file. */
	@Override
	public void close() throws IOException {
		try {
			Files.deleteIfExists(file);
		} finally {
			channel.close();
			HELD.remove(file);
		}
	}
}
